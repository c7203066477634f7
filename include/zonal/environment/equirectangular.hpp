// Longitude across, latitude down: the whole turn in a rectangle.
#pragma once

#include <array>
#include <cmath>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/vector3.hpp"
#include "solid_angle.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The middle of the picture is forward, +x; its upper edge is up, +z; to the left of the middle is left, +y, at a
/// quarter of the width; its left and right edges are both backward. A row is a polar angle theta = pi row / height, a
/// column an azimuth phi = pi - 2 pi column / width. Of any size; as a rule twice as wide as high. What all mappings
/// have: mapping.hpp.
struct Equirectangular {
  static constexpr const char* name = "equirectangular";
  int width, height;

  constexpr Equirectangular(int picture_width, int picture_height) : width(picture_width), height(picture_height) {}
  static constexpr const char* what_is_wrong(int, int) { return ""; }
  static constexpr double covered() { return double(4 * kPi); }

  constexpr bool has_direction(int, int) const { return true; }

  std::array<double, 3> direction(double column, double row) const {
    const double theta = double(kPi) * row / height, phi = double(kPi) * (1 - 2 * column / width);
    const double sine = std::sin(theta);
    return {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
  }

  template <class V>
  std::array<double, 2> texel(const V& v) const {
    const auto d = detail::as_direction<double>(v);
    const double phi = std::atan2(d.y, d.x), theta = std::atan2(std::hypot(d.x, d.y), d.z);
    return {detail::within(width * (0.5 - phi / double(2 * kPi)), 0, width),
            detail::within(height * theta / double(kPi), 0, height)};
  }

  /// dphi (cos theta_0 - cos theta_1), without the difference.
  double solid_angle(int, int row) const {
    const double half = double(kPi) / 2 / height;
    return double(4 * kPi) / width * std::sin((2 * row + 1) * half) * std::sin(half);
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
