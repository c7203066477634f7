// The clamped cosine.
#pragma once

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// I_l = integral of u^n P_l(u) from 0 to 1: I_0 = 1/(n+1), I_1 = 1/(n+2), I_l = (n-l+2)/(n+l+1) I_(l-2).
// All factors are known signs and ratios: no cancellation. K_l = sqrt((2l+1)/(4 pi)).
constexpr long double zonal_normalisation(int l) { return constexpr_sqrt((2 * l + 1) / (4 * kPi)); }
}  // namespace detail

/// f = max(cos theta, 0) / pi: a Lambert reflector of albedo 1 times the cosine. It integrates to 1.
/// Odd degrees beyond 1 are exactly zero.
struct LambertLobe {};

/// Its zonal coefficients to sink(l, value), rounded once.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project(LambertLobe, Sink&& sink) {
  long double even = 1.0L / 2, odd = 1.0L / 3;  // I_l for n = 1
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    long double& integral = l % 2 == 0 ? even : odd;
    if constexpr (l >= 2) integral *= (3.0L - l) / (2.0L + l);
    sink(l, T(2 * detail::zonal_normalisation(l) * integral));
  });
}

template <int N, class T>
constexpr Zh<N, T> project(LambertLobe lobe) {
  Zh<N, T> zh{};
  project<N, T>(lobe, [&](auto l, const T& value) { zh.values[l] = value; });
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
