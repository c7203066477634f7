// What exchanging y and z does to the harmonics of a degree: Y_l(x, z, y) = S_l Y_l(x, y, z).
//
// S_l is symmetric and its own inverse. But for the signs below and a factor sqrt(2) for each order that is not 0, its
// entry [m, k] is Wigner's d(pi/2) of |m| and |k|, which a recurrence leads down from k = l while m stays [1]. With
// both factors sqrt(2), that is for m > 0 and k > 0,
//
//   v_k = 2m / sqrt((l-k)(l+k+1)) v_(k+1) - sqrt((l-k-1)(l+k+2) / ((l-k)(l+k+1))) v_(k+2)
//
// from v_l = 2^(1-l) sqrt(binomial(2l, l+m)). It grows where it starts and swings after that, so that errors do not: a
// thousand degrees keep all digits but two. No other degree is needed.
//
// An entry [m, k] is zero unless Y_l^k is in y what Y_l^m is in z, even or odd, and the other way round: l^2 + l + 1 of
// the (2l+1)^2 are left. As an involution it is exact to 7e-19 at degree 10 and 2e-18 at 20 where long double has 64
// bits.
//
// [1] Trapani, Navaza, Calculation of spherical harmonics and Wigner d functions by FFT, Acta Crystallographica A 62,
//     2006.
#pragma once

#include <cstddef>

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

constexpr bool is_odd_in_y(int m) { return m < 0; }
constexpr bool is_swapped(int l, int m, int k) {
  return is_odd_in_y(k) != is_even_in_z(l, m) && is_odd_in_y(m) != is_even_in_z(l, k);
}

// The recurrence's factors of m v_(k+1) and of v_(k+2), 0 <= k < l.
constexpr long double swap_of_next(int l, int k) { return 2 / constexpr_sqrt((l - k) * (l + k + 1.0L)); }
constexpr long double swap_of_second(int l, int k) {
  return constexpr_sqrt((l - k - 1) * (l + k + 2.0L) / ((l - k) * (l + k + 1.0L)));
}
// v_l of m = 0, by that of the degree before; and of m > 0, by that of m - 1.
constexpr long double next_swap_corner(int l, long double before) { return before * constexpr_sqrt(1 - 0.5L / l); }
constexpr long double next_swap_edge(int l, int m, long double before) {
  return before * constexpr_sqrt((l - m + 1.0L) / (l + m) * (m == 1 ? 2 : 1));
}
// v_0 has one factor sqrt(2) less than the recurrence, which starts with both, has.
inline constexpr long double swap_of_zero = constexpr_sqrt(0.5L);

// Where v_k of m >= 0, k >= 0 stands, among the orders below 0 or not, and times which sign: that of m times that of k,
// and another in odd degrees where only one of m and k is odd.
constexpr int swap_sign(int order) { return order / 2 % 2 == 0 ? 1 : -1; }
constexpr int swap_sign(int l, int m, int k) {
  return swap_sign(m) * swap_sign(k) * ((m + k) % 2 == 1 && l % 2 == 1 ? -1 : 1);
}
constexpr int swap_row(int l, int m, int k) { return is_even_in_z(l, k) ? m : -m; }
constexpr int swap_column(int l, int m, int k) { return is_even_in_z(l, m) ? k : -k; }

template <int l>
struct SwapMatrix {
  long double values[static_cast<std::size_t>(2 * l + 1)][static_cast<std::size_t>(2 * l + 1)] = {};
  constexpr long double& operator()(int m, int k) { return values[l + m][l + k]; }
  constexpr long double operator()(int m, int k) const { return values[l + m][l + k]; }

  constexpr SwapMatrix() {
    long double last[static_cast<std::size_t>(l + 1)] = {}, second[static_cast<std::size_t>(l + 1)] = {};
    last[0] = 1 / swap_of_zero;
    for (int degree = 1; degree <= l; ++degree) last[0] = next_swap_corner(degree, last[0]);
    for (int m = 1; m <= l; ++m) last[m] = next_swap_edge(l, m, last[m - 1]);
    for (int k = l; k >= 0; --k) {
      const long double of_next = k < l ? swap_of_next(l, k) : 0, of_second = k < l ? swap_of_second(l, k) : 0;
      for (int m = 0; m <= l; ++m) {
        if (k < l) {
          const long double next = of_next * m * last[m] - of_second * second[m];
          second[m] = last[m];
          last[m] = next;
        }
        const int row = swap_row(l, m, k), column = swap_column(l, m, k);
        if (is_swapped(l, row, column)) {
          (*this)(row, column) = swap_sign(l, m, k) * (k == 0 ? swap_of_zero * last[m] : last[m]);
        }
      }
    }
  }
};
template <int l>
inline constexpr SwapMatrix<l> swap_matrix{};

// The entries of a row that are not zero: how many, and the order k of each.
constexpr int swap_terms(int l, int m) {
  int count = 0;
  for (int k = -l; k <= l; ++k) count += is_swapped(l, m, k) ? 1 : 0;
  return count;
}
constexpr int swap_order(int l, int m, int i) {
  for (int k = -l; k <= l; ++k) {
    if (is_swapped(l, m, k) && i-- == 0) return k;
  }
  return 0;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
