// What exchanging y and z does to the harmonics of a degree: Y_l(x, z, y) = S_l Y_l(x, y, z).
//
// S_l is symmetric and its own inverse, and follows from the ladder (basis/ladder.hpp), degree by degree. The swapped
// direction's z is y: for the orders |m| <= l, U_k being the steps up as matrices,
//
//   keep_up(l, m) S_(l+1)[m, :] = sum over k of S_l[m, k] U_y[k, :]
//
// and its x is x: for the two outermost ones
//
//   raise_up(l, l) S_(l+1)[+-(l+1), :] = sum over k of S_l[+-l, k] U_x[k, :] - lower_up(l, l) S_(l+1)[+-(l-1), :]
//
// An entry [m, k] is zero unless Y_l^k is in y what Y_l^m is in z, even or odd, and the other way round: l^2 + l + 1 of
// the (2l+1)^2 are left. As an involution it is exact to 6e-19 at degree 10 and 2e-18 at 20 where long double has 64
// bits.
#pragma once

#include <cstddef>

#include "../basis/ladder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

constexpr bool is_odd_in_y(int m) { return m < 0; }
constexpr bool is_swapped(int l, int m, int k) {
  return is_odd_in_y(k) != is_even_in_z(l, m) && is_odd_in_y(m) != is_even_in_z(l, k);
}

template <int l>
struct SwapMatrix {
  long double values[static_cast<std::size_t>(2 * l + 1)][static_cast<std::size_t>(2 * l + 1)] = {};
  constexpr long double& operator()(int m, int k) { return values[l + m][l + k]; }
  constexpr long double operator()(int m, int k) const { return values[l + m][l + k]; }
};

template <int l>
constexpr SwapMatrix<l> make_swap_matrix();
template <int l>
inline constexpr SwapMatrix<l> swap_matrix = make_swap_matrix<l>();

// Adds f times the step up in x or in y of (l, k) to a row of degree l+1: add(order, value).
template <class Add>
constexpr void add_step_x(int l, int k, long double f, const Add& add) {
  const int m = k < 0 ? -k : k, sign = k < 0 ? -1 : 1;
  add(sign * (m + 1), f * raise_up(l, m));
  if (m >= 2 || k == 1) add(sign * (m - 1), f * lower_up(l, m));
}
template <class Add>
constexpr void add_step_y(int l, int k, long double f, const Add& add) {
  const int m = k < 0 ? -k : k, sign = k < 0 ? -1 : 1;
  add(-sign * (m + 1), sign * f * raise_up(l, m));
  if (m >= 2 || k == -1) add(-sign * (m - 1), -sign * f * lower_up(l, m));
}

template <int l>
constexpr SwapMatrix<l> make_swap_matrix() {
  SwapMatrix<l> r;
  if constexpr (l == 0) {
    r(0, 0) = 1;
  } else if constexpr (l == 1) {  // -y, z, -x
    r(-1, 0) = r(0, -1) = -1;
    r(1, 1) = 1;
  } else {
    constexpr int below = l - 1;
    const SwapMatrix<below>& s = swap_matrix<below>;
    const auto add_to = [&](int row) {
      return [&r, row](int k, long double value) {
        if (is_swapped(l, row, k)) r(row, k) += value;
      };
    };
    for (int m = -below; m <= below; ++m) {
      for (int k = -below; k <= below; ++k) {
        if (is_swapped(below, m, k)) add_step_y(below, k, s(m, k), add_to(m));
      }
      const long double keep = keep_up(below, m);
      for (int k = -l; k <= l; ++k) r(m, k) /= keep;
    }
    for (const int sign : {-1, 1}) {
      const int row = sign * l, edge = sign * below, beside = sign * (below - 1);
      for (int k = -below; k <= below; ++k) {
        if (is_swapped(below, edge, k)) add_step_x(below, k, s(edge, k), add_to(row));
      }
      const bool has_beside = below >= 2 || sign > 0;  // sin(0 phi) is no harmonic
      const long double raise = raise_up(below, below), lower = lower_up(below, below);
      for (int k = -l; k <= l; ++k) {
        if (has_beside && is_swapped(l, row, k)) r(row, k) -= lower * r(beside, k);
        r(row, k) /= raise;
      }
    }
  }
  return r;
}

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
