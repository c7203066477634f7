// A triangle light approximated by a sphere [1, 4.4]: its centre of gravity, its area as the sphere's disc, and the
// cosine of its normal as a factor. Cheap, and good where the triangle looks small. polygon.hpp is exact.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "polygon.hpp"
#include "sphere.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Radiance 1 to both sides. In the triangle's plane its light is zero; the gradient there, which jumps from one side
/// to the other, is that of the side its vertices run around counterclockwise.
template <class T>
struct TriangleSphereLight {
  glm::vec<3, T> center, normal;
  T radius;

  /// [1] Eq. 24, 25. A triangle without an area, or of edges below 1e-35 in float, gives no light.
  static TriangleSphereLight approximate(const TriangleLight<T>& triangle) {
    const auto& p = triangle.vertices;
    const glm::vec<3, T> ab = p[1] - p[0], ac = p[2] - p[0];
    // Edges over the longest, so that neither their squares nor those of the area leave the range of T.
    T size = (std::numeric_limits<T>::min)() / std::numeric_limits<T>::epsilon();
    for (int i = 0; i < 3; ++i) size = (std::max)({size, std::abs(ab[i]), std::abs(ac[i])});
    const glm::vec<3, T> area = glm::cross(ab / size, ac / size);
    const T twice = std::sqrt(glm::dot(area, area));
    const glm::vec<3, T> center = p[0] + (ab + ac) / T(3);
    if (!(twice > T(0))) return {center, {T(0), T(0), T(1)}, T(0)};
    return {center, area / twice, size * std::sqrt(twice / T(2 * kPi))};
  }

  template <int N, class R>
  ZONAL_INLINE constexpr RadialProfile<N, R> profile(const Sight<R>& sight) const {
    return sphere_profile<N>(sight, R(radius));
  }
  /// |cos gamma| and its gradient, [1] Eq. 26, 28.
  template <class R>
  ZONAL_INLINE constexpr Modulation<R> modulation(const Sight<R>& sight) const {
    const R n[3] = {R(normal[0]), R(normal[1]), R(normal[2])};
    const R* w = sight.direction;
    const R cosine = detail::dot3(sight.direction, n);
    const R slope = select(R(0) < cosine, sight.inverse_distance, -sight.inverse_distance);
    return {abs(cosine),
            {slope * (cosine * w[0] - n[0]), slope * (cosine * w[1] - n[1]), slope * (cosine * w[2] - n[2])}};
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
