// Complex harmonics, as mathematics, SciPy and much of physics have them: with the phase of Condon and Shortley,
// Y_l^m = sqrt((2l+1)/(4pi) (l-m)!/(l+m)!) P_l^m(cos theta) exp(i m phi), so that for m > 0 and the real harmonics of
// this library Y_l^m = (R_l^m + i R_l^-m) / sqrt(2), and Y_l^-m = (-1)^m conj(Y_l^m).
//
// SciPy: sph_harm_y(l, m, theta, phi), theta from the z axis; the older sph_harm(m, l, phi, theta) is the same function
// with other names for its angles.
#pragma once

#include <complex>

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The coefficients c_lm = integral of f conj(Y_l^m) of a real function, of which f is the sum of c_lm Y_l^m, in the
/// order l(l+1)+m. T is a built-in scalar. One rounding a number.
template <int N, class T>
Sh<N, std::complex<T>> to_complex(const Sh<N, T>& sh) {
  constexpr T half = static_cast<T>(constexpr_sqrt(0.5L));
  Sh<N, std::complex<T>> r{};
  for (int l = 0; l < N; ++l) {
    r(l, 0) = sh(l, 0);
    for (int m = 1; m <= l; ++m) {
      const std::complex<T> c(half * sh(l, m), -half * sh(l, -m));
      r(l, m) = c;
      r(l, -m) = m % 2 == 0 ? std::conj(c) : -std::conj(c);
    }
  }
  return r;
}

/// Those of the real part of the function that complex coefficients make; where they are of a real function, all of it.
template <int N, class T>
Sh<N, T> from_complex(const Sh<N, std::complex<T>>& sh) {
  constexpr T half = static_cast<T>(constexpr_sqrt(0.5L));
  Sh<N, T> r{};
  for (int l = 0; l < N; ++l) {
    r(l, 0) = sh(l, 0).real();
    for (int m = 1; m <= l; ++m) {
      const std::complex<T> back = m % 2 == 0 ? std::conj(sh(l, -m)) : -std::conj(sh(l, -m));
      r(l, m) = half * (sh(l, m).real() + back.real());
      r(l, -m) = -half * (sh(l, m).imag() + back.imag());
    }
  }
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
