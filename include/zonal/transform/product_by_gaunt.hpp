// Products of few bands, term by term: the Gaunt coefficients that are not zero, in straight-line code.
#pragma once

#include "../basis/sh.hpp"
#include "../scalar/colour.hpp"
#include "../scalar/unroll.hpp"
#include "gaunt.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

template <class C>
ZONAL_INLINE constexpr C difference(const C& a, const C& b) {
  if constexpr (is_colour_v<C>) {
    return a + times(b, number_t<C>(-1));
  } else {
    return a - b;
  }
}

// a_i b_j + a_j b_i, or a_i b_i.
template <class C, int N, class A, class B>
ZONAL_INLINE constexpr C symmetric_product(const Sh<N, A>& a, const Sh<N, B>& b, int i, int j) {
  C sum = times(a.values[i], b.values[j]);
  if (i != j) add_times(sum, a.values[j], b.values[i]);
  return sum;
}

// sum = or += value * factor.
template <class C, class A, class F>
ZONAL_INLINE constexpr void give(C& sum, bool is_first, const A& value, const F& factor) {
  if (is_first) {
    sum = times(value, factor);
  } else {
    add_times(sum, value, factor);
  }
}

// Terms [first, last) of the table: `even` and `odd` times each coefficient to the cosine and the sine of their order.
template <int first, int last, int order, int K, int N, class C>
ZONAL_INLINE constexpr void give_terms(Sh<K, C>& sums, const C& value) {
  unroll<first, last>([&](auto t) ZONAL_INLINE {
    using Number = number_t<C>;
    constexpr int j = gaunt_table<N, K>.terms[t].j;
    constexpr bool is_first = gaunt_table<N, K>.terms[t].is_first;
    constexpr auto gaunt = rounded<Number>(gaunt_table<N, K>.terms[t].value);
    give(sums.values[sh_index(j, order)], is_first, value, Number(gaunt));
  });
}

// The K bands of a b (gaunt.hpp).
template <int K, int N, class A, class B>
ZONAL_INLINE constexpr Sh<K, product_t<A, B>> product_by_gaunt(const Sh<N, A>& a, const Sh<N, B>& b) {
  using C = product_t<A, B>;
  using Table = GauntTable<N, K>;
  Sh<K, C> sums{};
  unroll<0, Table::pair_count>([&](auto index) ZONAL_INLINE {
    constexpr typename Table::Pair pair = gaunt_table<N, K>.pairs[index];
    constexpr int m = pair.m, n = pair.n;
    constexpr int cosine = sh_index(pair.l, m), sine = sh_index(pair.l, -m);
    constexpr int other = sh_index(pair.k, n), other_sine = sh_index(pair.k, -n);
    if constexpr (pair.first == pair.last) {
      return;
    } else if constexpr (n == 0) {
      give_terms<pair.first, pair.last, m, K, N>(sums, symmetric_product<C>(a, b, cosine, other));
      if constexpr (m > 0) give_terms<pair.first, pair.last, -m, K, N>(sums, symmetric_product<C>(a, b, sine, other));
    } else {
      const C cosines = symmetric_product<C>(a, b, cosine, other), sines = symmetric_product<C>(a, b, sine, other_sine);
      const C mixed = symmetric_product<C>(a, b, sine, other);
      const C mixed_again = symmetric_product<C>(a, b, cosine, other_sine);
      if constexpr (pair.first < pair.middle) {
        give_terms<pair.first, pair.middle, m + n, K, N>(sums, difference(cosines, sines));
        give_terms<pair.first, pair.middle, -m - n, K, N>(sums, cosine == other ? mixed : mixed + mixed_again);
      }
      if constexpr (pair.middle < pair.last) {
        give_terms<pair.middle, pair.last, m - n, K, N>(sums, cosines + sines);
        if constexpr (m > n) give_terms<pair.middle, pair.last, n - m, K, N>(sums, difference(mixed, mixed_again));
      }
    }
  });
  return sums;
}

// The first N bands of a z, z being zonal, as a matrix for each order, and to each of its parts.
template <int N, int Orders, class Z, class Apply>
ZONAL_INLINE constexpr void for_each_zonal_factor(const Zh<N, Z>& z, Apply&& apply) {
  using Table = ZonalGauntTable<N, Orders>;
  unroll<0, Table::pair_count>([&](auto index) ZONAL_INLINE {
    constexpr typename Table::Pair pair = zonal_gaunt_table<N, Orders>.pairs[index];
    using Number = number_t<Z>;
    constexpr int first = zonal_gaunt_table<N, Orders>.terms[pair.first].k;
    constexpr auto first_gaunt = rounded<Number>(zonal_gaunt_table<N, Orders>.terms[pair.first].value);
    Z factor = times(z.values[first], Number(first_gaunt));
    unroll<pair.first + 1, pair.last>([&](auto t) ZONAL_INLINE {
      constexpr int k = zonal_gaunt_table<N, Orders>.terms[t].k;
      constexpr auto gaunt = rounded<Number>(zonal_gaunt_table<N, Orders>.terms[t].value);
      add_times(factor, z.values[k], Number(gaunt));
    });
    apply(pair.l, pair.j, pair.m, factor);
  });
}

template <int N, class A, class Z>
ZONAL_INLINE constexpr Sh<N, product_t<A, Z>> product_by_gaunt(const Sh<N, A>& a, const Zh<N, Z>& z) {
  Sh<N, product_t<A, Z>> sums{};
  for_each_zonal_factor<N, N>(z, [&](int l, int j, int m, const Z& factor) ZONAL_INLINE {
    for (int order = m; order >= -m; order -= m > 0 ? 2 * m : 1) {
      const int upper = sh_index(l, order), lower = sh_index(j, order);
      give(sums.values[upper], j == m, a.values[lower], factor);  // pairs begin with those of j = m
      if (l != j) give(sums.values[lower], false, a.values[upper], factor);
    }
  });
  return sums;
}
template <int N, class A, class Z>
ZONAL_INLINE constexpr Zh<N, product_t<A, Z>> product_by_gaunt(const Zh<N, A>& a, const Zh<N, Z>& z) {
  Zh<N, product_t<A, Z>> sums{};
  for_each_zonal_factor<N, 1>(z, [&](int l, int j, int, const Z& factor) ZONAL_INLINE {
    give(sums.values[l], j == 0, a.values[j], factor);
    if (l != j) give(sums.values[j], false, a.values[l], factor);
  });
  return sums;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
