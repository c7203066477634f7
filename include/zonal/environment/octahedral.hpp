// The faces of an octahedron, unfolded to a square.
//
// [1] Cigolle et al., A survey of efficient representations for independent unit vectors, JCGT 3(2), 2014.
#pragma once

#include <array>
#include <cmath>

#include "../scalar/vector3.hpp"
#include "solid_angle.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// As shaders address it [1]: the texture coordinates are (u + 1)/2 and (v + 1)/2 with (u, v) = (x, y) / (|x| + |y| +
/// |z|), where z is negative folded over the edges |u| + |v| = 1: ((1 - |v|) sign u, (1 - |u|) sign v). The first row
/// is that of v = -1. So +z is the middle of the picture, up; -z its corners; +x, forward, the middle of its right
/// edge; +y, left, the middle of its lower one. Square. What all mappings have: mapping.hpp.
struct Octahedral {
  static constexpr const char* name = "octahedral";
  int size;

  constexpr Octahedral(int width, int) : size(width) {}
  static constexpr const char* what_is_wrong(int width, int height) {
    return width == height ? "" : "it is not square";
  }
  static constexpr double covered() { return double(4 * kPi); }

  constexpr bool has_direction(int, int) const { return true; }

  std::array<double, 3> direction(double column, double row) const {
    // In units of a texel and from the middle, where halves are exact.
    const double n = size, u = 2 * column - n, v = 2 * row - n, z = n - std::abs(u) - std::abs(v);
    const double x = z < 0 ? std::copysign(n - std::abs(v), u) : u, y = z < 0 ? std::copysign(n - std::abs(u), v) : v;
    const double scale = 1 / std::sqrt(x * x + y * y + z * z);
    return {x * scale, y * scale, z * scale};
  }

  template <class V>
  std::array<double, 2> texel(const V& direction) const {
    const auto d = detail::as_direction<double>(direction);
    const double scale = 1 / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    double u = d.x * scale, v = d.y * scale;
    if (d.z < 0) {
      const double folded = std::copysign(1 - std::abs(v), u);
      v = std::copysign(1 - std::abs(u), v);
      u = folded;
    }
    return {detail::within(0.5 * size * (u + 1), 0, size), detail::within(0.5 * size * (v + 1), 0, size)};
  }

  /// Lines in the square are great circles as long as they stay on one face. A texel on an edge of the octahedron has a
  /// part on each side of it.
  double solid_angle(int column, int row) const {
    const int n = size;
    // In units of a texel, from the middle, mirrored to where u and v are positive; halved where the middle cuts them.
    const int left = std::abs(2 * column + 1 - n) - 1, low = std::abs(2 * row + 1 - n) - 1;
    const int copies = (left < 0 ? 2 : 1) * (low < 0 ? 2 : 1);
    return copies * quarter_solid_angle(left < 0 ? 0 : left, low < 0 ? 0 : low, left + 2, low + 2);
  }

 private:
  // Of the rectangle in the quarter of positive u and v, in units of half a texel, n of which are the side of it.
  double quarter_solid_angle(int u0, int v0, int u1, int v1) const {
    const int n = size;
    if (u1 + v1 <= n) return rectangle(u0, v0, u1, v1);
    // The other side of the edge u + v = n is that side's mirror image.
    if (u0 + v0 >= n) return rectangle(n - v1, n - u1, n - v0, n - u0);
    if (u0 + v0 == n - (u1 - u0) && u1 - u0 == v1 - v0) {  // along its diagonal
      return 2 * triangle({double(u0), double(v0)}, {double(u1), double(v0)}, {double(u0), double(v1)});
    }
    return cut(u0, v0, u1, v1) + cut(n - v1, n - u1, n - v0, n - u0);
  }

  using Point = std::array<double, 2>;
  detail::Corner corner(const Point& p) const { return {p[0], p[1], size - p[0] - p[1]}; }
  // The determinant of points in the plane u + v + w = n is n times that of their differences.
  double triangle(const Point& a, const Point& b, const Point& c) const {
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return detail::triangle_solid_angle(corner(a), corner(b), corner(c), size * std::abs(area));
  }
  double rectangle(int u0, int v0, int u1, int v1) const {
    const Point a{double(u0), double(v0)}, b{double(u1), double(v0)}, c{double(u1), double(v1)},
        d{double(u0), double(v1)};
    return triangle(a, b, c) + triangle(a, c, d);
  }
  // What lies below u + v = n, which cuts the rectangle: a fan from its lowest corner, whose edges are cut one by one.
  double cut(int u0, int v0, int u1, int v1) const {
    const Point corners[4] = {
        {double(u0), double(v0)}, {double(u1), double(v0)}, {double(u1), double(v1)}, {double(u0), double(v1)}};
    Point kept[6];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
      const Point &a = corners[i], &b = corners[(i + 1) % 4];
      const double above_a = a[0] + a[1] - size, above_b = b[0] + b[1] - size;
      if (above_a <= 0) kept[count++] = a;
      if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0)) {
        const double t = above_a / (above_a - above_b);
        kept[count++] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
      }
    }
    double sum = 0;
    for (int i = 2; i < count; ++i) sum += triangle(kept[0], kept[i - 1], kept[i]);
    return sum;
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
