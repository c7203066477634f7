// The registry's entry of the room `scalar` (kernel_list.hpp): the functions that every scalar must have.
#pragma once

#include "../scalar/math.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

struct Arcs : Kernel {
  static constexpr const char* name = "arcs";
  static constexpr const char* summary = "asin, acos, angle_from, and sine and cosine, by an angle's cosine and sine.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto angle = io.cap("angle", Domain::angle);
    const auto arc = io.output("arc", 5);
    arc[0] = asin(angle.cos_angle);
    arc[1] = acos(angle.cos_angle);
    arc[2] = angle_from(angle.cos_angle, angle.sin_angle);
    const auto turned = sin_cos(angle.cos_angle);
    arc[3] = turned.sine;
    arc[4] = turned.cosine;
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
