// The clamped cosine.
#pragma once

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// I_l = integral of u P_l(u) from 0 to 1: I_0 = 1/2, I_1 = 1/3, I_l = (3-l)/(l+2) I_(l-2). Known signs and ratios: no
// cancellation.
constexpr long double next_cosine_integral(int l, long double two_before) {
  return l == 0 ? 1.0L / 2 : l == 1 ? 1.0L / 3 : (3.0L - l) / (2.0L + l) * two_before;
}
constexpr long double cosine_integral(int l) { return next_cosine_integral(l, l < 2 ? 0 : cosine_integral(l - 2)); }
}  // namespace detail

/// f = max(cos theta, 0) / pi: a Lambert reflector of albedo 1 times the cosine. It integrates to 1.
/// Odd degrees beyond 1 are exactly zero.
struct LambertLobe {};

/// Its zonal coefficients to sink(l, value), rounded once.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project(LambertLobe, Sink&& sink) {
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    constexpr auto coefficient = rounded<T>(2 * detail::zonal_normalisation<l> * detail::cosine_integral(l));
    sink(l, T(coefficient));
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
