// What a surface receives from radiance of all directions, by its normal.
#pragma once

#include "../transform/convolve.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// E / pi, what a white matt surface sends out, as coefficients by the surface's normal: radiance convolved with the
/// clamped cosine over pi, whose factors are 1, 2/3, 1/4, 0, -1/24, ... Radiance's unit.
template <int N, class C>
constexpr Sh<N, C> irradiance_over_pi(const Sh<N, C>& radiance) {
  return convolve(radiance, project<N, detail::number_t<C>>(LambertLobe{}));
}

/// E, pi times that: W / m^2 where radiance is W / (m^2 sr).
template <int N, class C>
constexpr Sh<N, C> irradiance(const Sh<N, C>& radiance) {
  using T = detail::number_t<C>;
  constexpr auto pi = rounded<T>(kPi);
  return irradiance_over_pi(radiance) * T(pi);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
