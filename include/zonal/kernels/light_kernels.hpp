// The registry's entries of the room `light` (kernel_list.hpp).
#pragma once

#include "../light/sphere.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

namespace detail {
template <class Io>
SphereLight<typename Io::Scalar> take_sphere(Io& io) {
  const auto center = io.vector("center", Domain::position);
  return {{center[0], center[1], center[2]}, io.number("radius", Domain::length)};
}
}  // namespace detail

struct Sphere : Kernel {
  static constexpr const char* name = "project_sphere";
  static constexpr const char* summary = "A sphere light of radiance 1, seen from a receiver.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.template output_sh<N>("sh");
    project<N>(light, x[0], x[1], x[2], [&](auto l, auto m, const T& value) { sh[sh_index(l, m)] = value; });
  }
};

struct SphereWithGradient : Kernel {
  static constexpr const char* name = "project_sphere_with_gradient";
  static constexpr const char* summary = "The same, and the gradient by the receiver's position, per unit of length.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.template output_sh<N>("sh");
    const auto gradient = io.template output_gradient<N>("gradient");
    project_with_gradient<N>(light, x[0], x[1], x[2],
                             [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) {
                               sh[sh_index(l, m)] = value;
                               gradient.set(sh_index(l, m), gx, gy, gz);
                             });
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
