// The six faces of a cube around the eye, in one picture.
#pragma once

#include <array>
#include <cmath>

#include "../scalar/index.hpp"
#include "../scalar/vector3.hpp"
#include "solid_angle.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A signed axis: 1, 2, 3 are +x, +y, +z, and -1, -2, -3 the opposite.
using SignedAxis = int;

/// Where a face stands in the picture, in faces, and which way its middle, its right and its lower edge lie.
struct CubeFace {
  int column, row;
  SignedAxis middle, right, down;
};

namespace detail {
constexpr int axis_of(SignedAxis axis) { return (axis < 0 ? -axis : axis) - 1; }
constexpr int sign_of(SignedAxis axis) { return axis < 0 ? -1 : 1; }
inline double along(const std::array<double, 3>& v, SignedAxis axis) {
  return sign_of(axis) * v[static_cast<std::size_t>(axis_of(axis))];
}
}  // namespace detail

/// The face ahead is +x, that above it +z, that to its left +y: as one sees them from inside, unfolded, the one behind
/// under the lower one, upside down. Three faces wide, four high.
struct VerticalCrossLayout {
  static constexpr const char* name = "vertical cross";
  static constexpr int columns = 3, rows = 4;
  static constexpr CubeFace faces[6] = {{1, 1, 1, -2, -3},  {1, 3, -1, -2, 3}, {0, 1, 2, 1, -3},
                                        {2, 1, -2, -1, -3}, {1, 0, 3, -2, 1},  {1, 2, -3, -2, -1}};
};
/// The same, but the face behind stands upright beside the right one. Four faces wide, three high.
struct HorizontalCrossLayout {
  static constexpr const char* name = "horizontal cross";
  static constexpr int columns = 4, rows = 3;
  static constexpr CubeFace faces[6] = {{1, 1, 1, -2, -3},  {3, 1, -1, 2, -3}, {0, 1, 2, 1, -3},
                                        {2, 1, -2, -1, -3}, {1, 0, 3, -2, 1},  {1, 2, -3, -2, -1}};
};
/// The faces +x, -x, +y, -y, +z, -z, one under the other, each as OpenGL, Vulkan and Direct3D address it: a texture of
/// theirs, asked for the direction (x, y, z), answers what stands here for (x, y, z). So up is +y here.
struct VerticalFacesLayout {
  static constexpr const char* name = "vertical faces";
  static constexpr int columns = 1, rows = 6;
  static constexpr CubeFace faces[6] = {{0, 0, 1, -3, -2}, {0, 1, -1, 3, -2}, {0, 2, 2, 1, 3},
                                        {0, 3, -2, 1, -3}, {0, 4, 3, 1, -2},  {0, 5, -3, -1, -2}};
};
/// The same side by side.
struct HorizontalFacesLayout {
  static constexpr const char* name = "horizontal faces";
  static constexpr int columns = 6, rows = 1;
  static constexpr CubeFace faces[6] = {{0, 0, 1, -3, -2}, {1, 0, -1, 3, -2}, {2, 0, 2, 1, 3},
                                        {3, 0, -2, 1, -3}, {4, 0, 3, 1, -2},  {5, 0, -3, -1, -2}};
};

/// A cube in a picture of Layout::columns by Layout::rows faces, `size` texels a side. A face's texel (u, v), in
/// [-1, 1] to the right and down, lies at middle + u right + v down. What all mappings have: mapping.hpp.
template <class CubeLayout>
struct Cube {
  using Layout = CubeLayout;
  static constexpr const char* name = Layout::name;
  int size;

  constexpr Cube(int width, int) : size(width / Layout::columns) {}
  static constexpr const char* what_is_wrong(int width, int height) {
    constexpr long long columns = Layout::columns, rows = Layout::rows;
    return width % columns == 0 && width * rows == height * columns ? "" : "its faces are no squares of whole texels";
  }
  static constexpr double covered() { return double(4 * kPi); }

  /// The number of the face that a texel is of, in the order +x, -x, +y, -y, +z, -z; -1 beside the cross.
  constexpr int face(int column, int row) const {
    for (int i = 0; i < 6; ++i) {
      if (Layout::faces[i].column == column / size && Layout::faces[i].row == row / size) return i;
    }
    return -1;
  }
  constexpr bool has_direction(int column, int row) const { return face(column, row) >= 0; }

  std::array<double, 3> direction(double column, double row) const {
    const int limit[2] = {Layout::columns * size - 1, Layout::rows * size - 1};
    const int at = face(nearest(column, limit[0]), nearest(row, limit[1]));
    if (at < 0) return {0, 0, 0};
    const CubeFace& f = Layout::faces[at];
    const double u = 2 * (column - f.column * size) / size - 1, v = 2 * (row - f.row * size) / size - 1;
    const double scale = 1 / std::sqrt(1 + u * u + v * v);
    std::array<double, 3> d{};
    set(d, f.middle, scale);
    set(d, f.right, u * scale);
    set(d, f.down, v * scale);
    return d;
  }

  template <class V>
  std::array<double, 2> texel(const V& v) const {
    const auto d = detail::as_direction<double>(v);
    const std::array<double, 3> w{d.x, d.y, d.z};
    int at = 0;
    for (int i = 1; i < 6; ++i) {
      if (detail::along(w, Layout::faces[i].middle) > detail::along(w, Layout::faces[at].middle)) at = i;
    }
    const CubeFace& f = Layout::faces[at];
    const double half = 0.5 * size / detail::along(w, f.middle);
    const double left = double(f.column) * size, top = double(f.row) * size;
    return {detail::within(left + 0.5 * size + half * detail::along(w, f.right), left, left + size),
            detail::within(top + 0.5 * size + half * detail::along(w, f.down), top, top + size)};
  }

  double solid_angle(int column, int row) const {
    return has_direction(column, row) ? face_solid_angle(column % size, row % size) : 0.0;
  }
  /// The same by the place in a face: two triangles, whose corners' determinants are the texel's area.
  double face_solid_angle(int column, int row) const {
    const double side = 2.0 / size, u = edge(column), v = edge(row), u1 = edge(column + 1), v1 = edge(row + 1);
    const detail::Corner a(u, v, 1), b(u1, v, 1), c(u1, v1, 1), d(u, v1, 1);
    return detail::triangle_solid_angle(a, b, c, side * side) + detail::triangle_solid_angle(a, c, d, side * side);
  }

  constexpr bool is_whole(int column, int row) const { return has_direction(column, row); }
  static constexpr double solid_angle_scale() { return 1; }
  double density(double column, double row) const {
    const double u = in_face(column), v = in_face(row), length2 = 1 + u * u + v * v;
    return 4.0 / (double(size) * size) / (length2 * std::sqrt(length2));
  }
  double densest(int column, int row) const {
    return density(nearest_to_middle(column % size), nearest_to_middle(row % size));
  }

 private:
  // Of a place, from -1 to 1.
  double in_face(double place) const {
    const double in_texels = place - size * std::floor(place / size);
    return (2 * in_texels - size) / size;
  }
  double nearest_to_middle(int i) const { return detail::within(0.5 * size, i, i + 1); }
  double edge(int i) const { return double(2 * i - size) / size; }
  static int nearest(double place, int last) { return detail::index_below(place, last); }
  static void set(std::array<double, 3>& v, SignedAxis axis, double value) {
    v[static_cast<std::size_t>(detail::axis_of(axis))] = detail::sign_of(axis) * value;
  }
};

using VerticalCross = Cube<VerticalCrossLayout>;
using HorizontalCross = Cube<HorizontalCrossLayout>;
using VerticalFaces = Cube<VerticalFacesLayout>;
using HorizontalFaces = Cube<HorizontalFacesLayout>;

}  // namespace ZONAL_TARGET
}  // namespace zonal
