// The constants of the basis, computed from their formulas at compile time and rounded once where used.
//
// With Q_l^m the associated Legendre polynomial divided by sin^m theta, and
// J_l^m = sqrt((2l+1)/(4 pi) (l-m)!/(l+m)!), times sqrt(2) (-1)^m for m > 0 (the Condon-Shortley phase), let
// q_l^m = J_l^m Q_l^m(z). Then Y_l^m = q_l^m Re (x+iy)^m, Y_l^-m = q_l^m Im (x+iy)^m, and
//
//   q_l^m = raise[l][m] z q_(l-1)^m - lower[l][m] q_(l-2)^m                              [1] Eq. 7-11, normalised
//
// The first three above the diagonal are short enough to stand as polynomials:
//   q_(m+1) = linear z,   q_(m+2) = square[1] z^2 + square[0],   q_(m+3) = z (cube[1] z^2 + cube[0])
//
// [1] Sloan, Efficient Spherical Harmonic Evaluation, JCGT 2(2), 2013.
#pragma once

#include <cstddef>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// q_m^m from q_(m-1)^(m-1).
constexpr long double next_diagonal(int m, long double before) {
  return m == 0   ? constexpr_sqrt(1 / (4 * kPi))
         : m == 1 ? -constexpr_sqrt(3 / (4 * kPi))
                  : -before * constexpr_sqrt((2 * m + 1.0L) / (2 * m));
}
}  // namespace detail

template <int N>
struct BasisTable {
  static constexpr std::size_t size = N;
  long double raise[size][size] = {}, lower[size][size] = {};
  long double diagonal[size] = {}, linear[size] = {}, square[size][2] = {}, cube[size][2] = {};

  constexpr BasisTable() {
    for (int m = 0; m < N; ++m) {
      diagonal[m] = detail::next_diagonal(m, m == 0 ? 0 : diagonal[m - 1]);
      for (int l = m + 1; l < N; ++l) {
        const long double a = l + m, b = l - m;
        raise[l][m] = constexpr_sqrt((2 * l + 1) * (2 * l - 1.0L) / (a * b));
        lower[l][m] = l < m + 2 ? 0 : constexpr_sqrt((2 * l + 1) * (a - 1) * (b - 1) / ((2 * l - 3) * a * b));
      }
      if (m + 1 < N) linear[m] = raise[m + 1][m] * diagonal[m];
      if (m + 2 < N) {
        square[m][1] = raise[m + 2][m] * linear[m];
        square[m][0] = -lower[m + 2][m] * diagonal[m];
      }
      if (m + 3 < N) {
        cube[m][1] = raise[m + 3][m] * square[m][1];
        cube[m][0] = raise[m + 3][m] * square[m][0] - lower[m + 3][m] * linear[m];
      }
    }
  }
};

template <int N>
inline constexpr BasisTable<N> basis_table{};

namespace detail {
// The recurrence: q_l^m from the two degrees below it.
template <class T>
ZONAL_INLINE constexpr T next_legendre(const T& raise, const T& lower, const T& z, const T& last, const T& below) {
  return raise * z * last - lower * below;
}
// c + is times x + iy.
template <class T>
ZONAL_INLINE constexpr void turn(const T& x, const T& y, T& c, T& s) {
  const T next = x * c - y * s;
  s = x * s + y * c;
  c = next;
}
}  // namespace detail

}  // namespace ZONAL_TARGET
}  // namespace zonal
