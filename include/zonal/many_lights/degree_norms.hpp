// What a band-limited function, its derivative and its second derivative are at most, anywhere, by the norms of its
// degrees alone: sum_m f_l^m Y_l^m(w) is no more than |f_l| sqrt((2l+1)/4pi), by Cauchy, Schwarz and the addition
// theorem, and it is just that in one direction where one degree is all there is. Along a great circle the same holds
// of its derivatives, with those of P_l(cos) at 0: with k = l(l+1) its second is -k/2, its fourth (3k^2 - 2k)/8.
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

inline float value_of_norm(int l) { return std::sqrt(float(2 * l + 1) / float(4 * kPi)); }
inline float slope_of_norm(int l) { return value_of_norm(l) * std::sqrt(float(l * (l + 1)) / 2); }
inline float curvature_of_norm(int l) {
  const float k = float(l * (l + 1));
  return value_of_norm(l) * std::sqrt(k * (3 * k - 2) / 8);
}

/// The norm of each degree times factor(l), added up, by channel.
template <int N, class Factor>
glm::vec3 sum_of_norms(const Sh<N, glm::vec3>& sh, const Factor& factor) {
  glm::vec3 sum(0.0F);
  for (int l = 0; l < N; ++l) {
    glm::vec3 squares(0.0F);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) squares += sh.values[i] * sh.values[i];
    sum += factor(l) * glm::sqrt(squares);
  }
  return sum;
}

inline float greatest_component(const glm::vec3& v) { return (glm::max)(v.x, (glm::max)(v.y, v.z)); }

}  // namespace detail

/// The greatest absolute value that the function can have in any direction, RGB;
template <int N>
glm::vec3 greatest_value(const Sh<N, glm::vec3>& sh) {
  return detail::sum_of_norms(sh, detail::value_of_norm);
}
/// the greatest derivative along any great circle, per radian;
template <int N>
glm::vec3 greatest_slope(const Sh<N, glm::vec3>& sh) {
  return detail::sum_of_norms(sh, detail::slope_of_norm);
}
/// and the greatest second derivative.
template <int N>
glm::vec3 greatest_curvature(const Sh<N, glm::vec3>& sh) {
  return detail::sum_of_norms(sh, detail::curvature_of_norm);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
