// The cosine power.
//
// z_l = (n+1) K_l I_l, K_l = sqrt((2l+1)/(4 pi)), with I_l the integral of u^n P_l(u) over [0, 1] [1, 3.3.1], by
// I_0 = 1/(n+1), I_1 = 1/(n+2), I_l = (n-l+2)/(n+l+1) I_(l-2).
// For a real n the product runs through zero near an integer, as it should: each factor is exact to one rounding.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination.
#pragma once

#include <type_traits>

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// f = (n+1)/(2 pi) max(cos theta, 0)^n for a real exponent n >= 0. It integrates to 1.
template <class T>
struct PhongLobe {
  static_assert(!std::is_integral_v<T>, "an exponent of type int: write 5.0f");
  T exponent;
};

namespace detail {
// I_l / I_(l-2).
template <class T>
ZONAL_INLINE constexpr T phong_ratio(const T& n, int l) {
  return (n - T(l - 2)) / (n + T(l + 1));
}
}  // namespace detail

/// Its zonal coefficients to sink(l, value).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project(const PhongLobe<T>& lobe, Sink&& sink) {
  const T n = lobe.exponent;
  T even = T(1), odd = (n + T(1)) / (n + T(2));  // (n+1) I_l
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    constexpr auto normalisation = rounded<T>(detail::zonal_normalisation<l>);
    T& integral = l % 2 == 0 ? even : odd;
    if constexpr (l >= 2) integral = integral * detail::phong_ratio(n, l);
    sink(l, T(normalisation) * integral);
  });
}

template <int N, class T>
constexpr Zh<N, T> project(const PhongLobe<T>& lobe) {
  Zh<N, T> zh{};
  project<N>(lobe, [&](auto l, const T& value) ZONAL_INLINE { zh.values[l] = value; });
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
