// Solid angles of what great circles bound, and what else mappings share.
//
// [1] Van Oosterom, Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng. 30(2), 1983.
#pragma once

#include <cmath>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// A vector, not of unit length, with its length.
struct Corner {
  double x, y, z, length;
  Corner(double px, double py, double pz) : x(px), y(py), z(pz), length(std::sqrt(px * px + py * py + pz * pz)) {}
};
inline double dot3(const Corner& a, const Corner& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// atan(x), x >= 0, without the call where x is small, as it is of nearly all texels.
inline double small_atan(double x) {
  if (!(x < 0.03)) return std::atan(x);
  const double x2 = x * x;
  return x * (1 - x2 * (1.0 / 3 - x2 * (1.0 / 5 - x2 * (1.0 / 7 - x2 * (1.0 / 9 - x2 / 11)))));
}

// Of a spherical triangle, less than a half space; `determinant` is that of its corners, which a caller knows without
// cancellation: [1] Eq. 8.
inline double triangle_solid_angle(const Corner& a, const Corner& b, const Corner& c, double determinant) {
  const double below =
      a.length * b.length * c.length + dot3(a, b) * c.length + dot3(b, c) * a.length + dot3(c, a) * b.length;
  return 2 * small_atan(determinant / below);
}

// A coordinate brought into [begin, end): on an edge, rounded, or of no direction at all, it would else be of a texel
// that is none.
inline double within(double x, double begin, double end) {
  return !(x >= begin) ? begin : x < end ? x : std::nextafter(end, begin);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
