// Gaunt coefficients, the integrals of three harmonics, at compile time: of all that are not zero, once.
//
// With Y_l^m = p_l^m(z) cos(m phi) and Y_l^-m = p_l^m(z) sin(m phi), m >= 0, the product of two harmonics is a product
// of p, which Gauss quadrature in z integrates exactly, and one of cosines and sines,
//
//   cos m cos n = (cos(m-n) + cos(m+n)) / 2,  sin m sin n = (cos(m-n) - cos(m+n)) / 2,
//   sin m cos n = (sin(m+n) + sin(m-n)) / 2,
//
// so of all four products of (l, +-m) and (k, +-n) the coefficients are one number for the order m + n and one for m -
// n,
//
//   G(l m, k n, j) = w integral of p_l^m p_k^n p_j^(m+-n) dz,
//
// w being 2 pi where m = n = 0, pi where one of the three orders is 0, and pi/2 elsewhere. It is zero unless
// |l - k| <= j <= l + k and l + k + j is even, and at a few places more.
#pragma once

#include <cstddef>

#include "../basis/sh.hpp"
#include "../basis/table.hpp"
#include "../scalar/constexpr_math.hpp"
#include "../scalar/half_gauss_rule.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// p_l^m, l < N, at the nodes z >= 0 of a Gauss rule; at -z it is (-1)^(l+m) times that.
template <int N, int Size>
struct LegendreGrid {
  static constexpr int count = HalfGaussRule<Size>::count;
  long double values[static_cast<std::size_t>(count)][static_cast<std::size_t>(even_index(N, 0))] = {};
  long double weights[static_cast<std::size_t>(count)] = {};  // of both, z and -z

  constexpr LegendreGrid() {
    const HalfGaussRule<Size> rule;
    const BasisTable<N> table;
    for (int i = 0; i < count; ++i) {
      const long double z = rule.nodes[i], sine = constexpr_sqrt(1 - z * z);
      weights[i] = 2 * i + 1 == Size ? rule.weights[i] : 2 * rule.weights[i];
      long double power = 1;  // sin^m
      for (int m = 0; m < N; ++m) {
        long double last = table.diagonal[m] * power, below = 0;
        values[i][even_index(m, m)] = last;
        for (int l = m + 1; l < N; ++l) {
          const long double next = table.raise[l][m] * z * last - table.lower[l][m] * below;
          below = last;
          last = next;
          values[i][even_index(l, m)] = next;
        }
        power *= sine;
      }
    }
  }

  // Of three of them, by z from -1 to 1, if the sum of l + m is even; otherwise it is 0, which this is not.
  constexpr long double integral(int a, int b, int c) const {
    long double sum = 0;
    for (int i = 0; i < count; ++i) sum += weights[i] * values[i][a] * values[i][b] * values[i][c];
    return sum;
  }
};

// An integral that is zero but for rounding: of the others the smallest is 5e-6 up to 10 bands.
constexpr bool is_zero_integral(long double x) { return -1e-12L < x && x < 1e-12L; }

// How many nodes integrate three harmonics exactly, two of N bands and one of K: degree 2N + K - 3.
constexpr int gaunt_nodes(int N, int K) { return N + (K - 1) / 2; }

// What each pair of (l, m) and (k, n), m and n >= 0, gives to a product of N bands by N bands, of which K are kept.
template <int N, int K>
struct GauntTable {
  static_assert(N <= K && K <= 2 * N - 1, "a product of N bands has N to 2N - 1");

  // Pairs of equal (m, n) stand together: what they add to is then few coefficients. Once for (l, m), (k, n) and
  // (k, n), (l, m): m > n, or m = n and l >= k.
  struct Pair {
    int l, m, k, n;
    int first, middle, last;  // terms [first, middle) are of order m + n, [middle, last) of m - n, if n > 0
  };
  struct Term {
    int j;
    bool is_first;  // of those that are added to (j, m + n), or (j, m - n)
    long double value;
  };

  static constexpr int lowest_degree(int l, int k, int order) {
    const int j = l - k < 0 ? k - l : l - k;
    return j >= order ? j : order + (order - j) % 2;
  }
  static constexpr int highest_degree(int l, int k) { return l + k < K ? l + k : K - 1 - (l + k + K - 1) % 2; }

  template <class Visit>
  static constexpr void for_each_pair(Visit visit) {
    for (int m = 0; m < N; ++m) {
      for (int n = 0; n <= m; ++n) {
        for (int l = m; l < N; ++l) {
          for (int k = n; k < N && !(m == n && k > l); ++k) visit(l, m, k, n);
        }
      }
    }
  }
  static constexpr int terms_of(int l, int k, int order) {
    const int low = lowest_degree(l, k, order), high = highest_degree(l, k);
    return low <= high ? (high - low) / 2 + 1 : 0;
  }
  static constexpr int pair_count = even_index(N, 0) * (even_index(N, 0) + 1) / 2;
  static constexpr int count_terms() {
    int count = 0;
    for_each_pair(
        [&count](int l, int m, int k, int n) { count += terms_of(l, k, m + n) + (n > 0 ? terms_of(l, k, m - n) : 0); });
    return count;
  }
  static constexpr int most_terms = count_terms();

  Pair pairs[static_cast<std::size_t>(pair_count)] = {};
  Term terms[static_cast<std::size_t>(most_terms)] = {};

  constexpr GauntTable() {
    const LegendreGrid<K, gaunt_nodes(N, K)> grid;
    bool is_filled[static_cast<std::size_t>(even_index(K, 0))] = {};
    int pair = 0, term = 0;
    const auto add_terms = [&](int l, int m, int k, int n, int order) {
      for (int j = lowest_degree(l, k, order); j <= highest_degree(l, k); j += 2) {
        const long double by_z = grid.integral(even_index(l, m), even_index(k, n), even_index(j, order));
        if (is_zero_integral(by_z)) continue;
        const int zeros = (m == 0) + (n == 0) + (order == 0);
        bool& filled = is_filled[even_index(j, order)];
        terms[term++] = {j, !filled, by_z * kPi * (zeros == 3 ? 2.0L : zeros == 1 ? 1.0L : 0.5L)};
        filled = true;
      }
    };
    for_each_pair([&](int l, int m, int k, int n) {
      Pair& entry = pairs[pair++];
      entry = {l, m, k, n, term, 0, 0};
      add_terms(l, m, k, n, m + n);
      entry.middle = term;
      if (n > 0) add_terms(l, m, k, n, m - n);
      entry.last = term;
    });
  }
};

template <int N, int K>
inline constexpr GauntTable<N, K> gaunt_table{};

// The same where the second harmonic is zonal, (k, 0): it couples (l, m) with (j, m) alone, and (l, -m) with (j, -m) by
// the same numbers. Of the orders 0 to Orders - 1, for j <= l.
template <int N, int Orders>
struct ZonalGauntTable {
  struct Pair {
    int l, j, m;
    int first, last;  // terms
  };
  struct Term {
    int k;
    long double value;
  };

  template <class Visit>
  static constexpr void for_each_pair(Visit visit) {
    for (int m = 0; m < Orders; ++m) {
      for (int l = m; l < N; ++l) {
        for (int j = m; j <= l; ++j) visit(l, j, m);
      }
    }
  }
  static constexpr int count(bool of_terms) {
    int count = 0;
    for_each_pair([&](int l, int j, int) { count += of_terms ? ((l + j < N ? l + j : N - 1) - (l - j)) / 2 + 1 : 1; });
    return count;
  }
  static constexpr int pair_count = count(false), most_terms = count(true);

  Pair pairs[static_cast<std::size_t>(pair_count)] = {};
  Term terms[static_cast<std::size_t>(most_terms)] = {};

  constexpr ZonalGauntTable() {
    const LegendreGrid<N, gaunt_nodes(N, N)> grid;
    int pair = 0, term = 0;
    for_each_pair([&](int l, int j, int m) {
      pairs[pair].first = term;
      for (int k = l - j; k <= l + j && k < N; k += 2) {
        const long double by_z = grid.integral(even_index(l, m), even_index(k, 0), even_index(j, m));
        if (!is_zero_integral(by_z)) terms[term++] = {k, by_z * kPi * (m == 0 ? 2 : 1)};
      }
      pairs[pair] = {l, j, m, pairs[pair].first, term};
      ++pair;
    });
  }
};
template <int N, int Orders>
inline constexpr ZonalGauntTable<N, Orders> zonal_gaunt_table{};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
