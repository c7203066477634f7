// The registry's entry of the room `screen` (kernel_list.hpp).
#pragma once

#include "../screen/surface.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

struct IsSameSurface : Kernel {
  static constexpr const char* name = "is_same_surface";
  static constexpr const char* summary = "1 where two pixels see one continuous surface, else 0.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto take = [&](const char* position, const char* normal, const char* depth, const char* mesh,
                          const char* material) -> ScreenSurface<T> {
      const auto x = io.vector(position, Domain::position), n = io.vector(normal, Domain::unit_vector);
      const T distance = io.number(depth, Domain::length);
      const T of_mesh = io.number(mesh, Domain::identity), of_material = io.number(material, Domain::identity);
      return {{x[0], x[1], x[2]}, {n[0], n[1], n[2]}, distance, of_mesh, of_material};
    };
    const auto a = take("position_a", "normal_a", "depth_a", "mesh_a", "material_a");
    const auto b = take("position_b", "normal_b", "depth_b", "mesh_b", "material_b");
    const T cos_normal = io.number("cos_normal", Domain::cosine);
    const T plane_distance = io.number("plane_distance", Domain::radius);
    const auto is_same = io.output("is_same", 0);
    is_same[0] = select(is_same_surface(a, b, cos_normal, plane_distance), T(1), T(0));
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
