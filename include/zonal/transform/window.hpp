// Windows against ringing: each degree is multiplied by a factor that falls from 1 towards 0 at degree `width`.
//
// [1] Sloan, Stupid spherical harmonics tricks, GDC 2008.
#pragma once

#include <type_traits>

#include "../basis/sh.hpp"
#include "../scalar/math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class Window { none, hann, sinc };

/// The factor of degree l >= 0: hann (1 + cos(pi l/width))/2, sinc sin(pi l/width)/(pi l/width) [1], and 0 from the
/// width on. Degree 0 is kept as it is, whatever the width.
template <class T, class = std::enable_if_t<!std::is_integral_v<T>>>
ZONAL_INLINE constexpr T window_factor(Window window, int degree, const T& width) {
  if (window == Window::none || degree == 0) return T(1);
  constexpr auto half_pi = rounded<T>(kPi / 2);
  const auto is_within = T(degree) < width;
  // (1 + cos(2x))/2 = cos^2 x, sin(2x) = 2 sin x cos x
  const T half = T(half_pi) * select(is_within, T(degree) / width, T(1));
  const SinCos<T> at = sin_cos(half);
  return select(is_within, at.cosine * (window == Window::hann ? at.cosine : at.sine / half), T(0));
}

template <class Width, std::enable_if_t<std::is_integral_v<Width>, int> = 0>
constexpr double window_factor(Window window, int degree, Width width) {
  using T = std::conditional_t<std::is_integral_v<Width>, double, Width>;  // or it would be compiled with the header
  return window_factor<T>(window, degree, static_cast<T>(width));
}

namespace detail {
template <class C, class Width, class Degree>
constexpr C scale_degrees(C coefficients, Window window, Width width, Degree last_of_degree) {
  for (int l = 0, i = 0; l < C::bands; ++l) {
    const double factor = window_factor(window, l, width);
    for (; i <= last_of_degree(l); ++i) {
      using T = std::decay_t<decltype(coefficients[i])>;
      coefficients[i] = times(coefficients[i], static_cast<number_t<T>>(factor));
    }
  }
  return coefficients;
}
}  // namespace detail

/// The windowed coefficients. `width` defaults to the number of bands: degree N would be the first at zero.
template <int N, class T>
constexpr Sh<N, T> apply_window(const Sh<N, T>& sh, Window window, double width = N) {
  return detail::scale_degrees(sh, window, width, [](int l) { return sh_index(l, l); });
}
template <int N, class T>
constexpr EvenSh<N, T> apply_window(const EvenSh<N, T>& sh, Window window, double width = N) {
  return detail::scale_degrees(sh, window, width, [](int l) { return even_index(l, l); });
}
template <int N, class T>
constexpr Zh<N, T> apply_window(const Zh<N, T>& zh, Window window, double width = N) {
  return detail::scale_degrees(zh, window, width, [](int l) { return l; });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
