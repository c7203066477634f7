// Irradiance from two bands that is never negative: the model of Geomerics' Enlighten [1].
//
//   E / pi = r0 (a + (1 - a) (p + 1) q^p),  q = (1 + cos) / 2,  p = 1 + 2 s,  a = (1 - s) / (1 + s),  s = |r1| / r0
//
// r0 being the mean of radiance and r1 the mean of radiance times direction, so 0 <= s <= 1, and cos the cosine between
// the normal and r1. With coefficients of radiance, r0 = f_0 / (2 sqrt(pi)) and s = |f_1| / (sqrt(3) f_0): code in
// which s = |f_1| / (2 f_0) and r0 = f_0 stands is an approximation of this, up to 13 % off.
//
// Its mean over all normals is r0, exactly, so no energy is lost. Light from all sides (s = 0) gives r0, and from one
// direction (s = 1) 4 r0 q^3: 4 r0 for the normal that faces it, as it has to be, and 0 for that which looks away. The
// first moment is 3 (1 + 2 s) / ((1 + s) (3 + 2 s)) of the right one: that at s = 0 and 1/2, 1.0294 of it at most (s =
// 0.207), 0.9 at s = 1.
//
// [1] Hazel, Converting SH radiance to irradiance, 2017, after work with Doran at Geomerics.
#pragma once

#include "../scalar/math.hpp"
#include "channels.hpp"
#include "zh3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// log(q) for 2^-63 <= q <= 1, below that log(2^-63): powers of 2 are split off exactly, and the rest is between
// sqrt(1/2) and sqrt(2), where log(m) = 2 artanh((m-1)/(m+1)).
template <class T>
ZONAL_INLINE constexpr T log_of_fraction(const T& q) {
  T m = maximum(q, T(0x1p-63L)), exponent = T(0);
  unroll<0, 6>([&](auto i) ZONAL_INLINE {
    constexpr int digits = 32 >> i;
    constexpr auto power = static_cast<long double>(1ULL << digits);
    const auto is_small = m < T(1 / power);
    m = select(is_small, m * T(power), m);
    exponent = select(is_small, exponent - T(digits), exponent);
  });
  const auto is_low = m < T(0.7071067811865475244L);
  m = select(is_low, m + m, m);
  exponent = select(is_low, exponent - T(1), exponent);

  constexpr int terms = digits_v<T> <= 24 ? 5 : digits_v<T> <= 53 ? 11 : 13;  // the first left out is below 1/4 ulp
  const T z = (m - T(1)) / (m + T(1)), square = z * z;
  T sum = T(1.0L / (2 * terms - 1));
  unroll<1, terms>([&](auto i) ZONAL_INLINE { sum = sum * square + T(1.0L / (2 * (terms - i) - 1)); });
  constexpr auto log_2 = rounded<T>(0.693147180559945309417232121458176568L);
  return exponent * T(log_2) + (z + z) * sum;
}

// q^p for 0 <= q <= 1, 1 <= p <= 3.
template <class T>
ZONAL_INLINE constexpr T power_of_fraction(const T& q, const T& p) {
  return exp(p * log_of_fraction(q));
}
}  // namespace detail

/// E / pi at a normal, a unit vector, from a channel's radiance of two bands; never negative. A mean that is not
/// positive gives 0, and coefficients that no radiance has, s > 1, count as s = 1. The kernel, for any scalar.
template <class T, class Direction>
ZONAL_INLINE constexpr T nonlinear_irradiance_over_pi(const Sh<2, T>& radiance, const Direction& normal, Index<1>) {
  constexpr auto to_mean = rounded<T>(detail::zonal_normalisation<0>);
  constexpr auto to_share = rounded<T>(1 / constexpr_sqrt(3.0L));
  T axis[3];
  detail::vector_of_linear(radiance, axis);
  const T length = detail::to_unit(axis);
  const auto n = detail::as_direction<T>(normal);
  const T share = minimum(T(to_share) * length / maximum(radiance.values[0], T(1e-30L)), T(1));
  const T q = clamp(T(0.5L) + T(0.5L) * detail::along(axis, n), T(0), T(1));
  const T p = T(1) + share + share, a = (T(1) - share) / (T(1) + share);
  const T shape = a + (T(1) - a) * (p + T(1)) * detail::power_of_fraction(q, p);
  return maximum(radiance.values[0], T(0)) * T(to_mean) * shape;
}

/// The same of numbers or colours, each channel for itself.
template <class C, class Direction>
constexpr C nonlinear_irradiance_over_pi(const Sh<2, C>& radiance, const Direction& normal) {
  if constexpr (!detail::is_colour_v<C>) {
    return nonlinear_irradiance_over_pi(radiance, normal, Index<1>{});
  } else {
    C value = radiance.values[0];
    for (int c = 0; c < detail::channels_v<C>; ++c) {
      detail::channel_of(value, c) =
          nonlinear_irradiance_over_pi(detail::take_channel<detail::number_t<C>>(radiance, c), normal, Index<1>{});
    }
    return value;
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
