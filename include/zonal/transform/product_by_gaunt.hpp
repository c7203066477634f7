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
template <int i, int j, class C, int N, class A, class B>
ZONAL_INLINE constexpr C symmetric_product(const Sh<N, A>& a, const Sh<N, B>& b) {
  C sum = times(a.values[i], b.values[j]);
  if constexpr (i != j) add_times(sum, a.values[j], b.values[i]);
  return sum;
}

// The K bands of a b (gaunt.hpp).
template <int K, int N, class A, class B>
ZONAL_INLINE constexpr Sh<K, product_t<A, B>> product_by_gaunt(const Sh<N, A>& a, const Sh<N, B>& b) {
  using C = product_t<A, B>;
  using Table = GauntTable<N, K>;
  Sh<K, C> sums{};
  // Of term t, `value` times its coefficient is added to the order that is given.
  const auto add = [&](auto t, auto order, const C& value) ZONAL_INLINE {
    using Number = number_t<C>;
    constexpr typename Table::Term term = gaunt_table<N, K>.terms[t];
    constexpr auto gaunt = rounded<Number>(term.value);
    C& sum = sums.values[sh_index(term.j, order)];
    if constexpr (term.is_first) {
      sum = times(value, Number(gaunt));
    } else {
      add_times(sum, value, Number(gaunt));
    }
  };
  unroll<0, Table::pair_count>([&](auto index) ZONAL_INLINE {
    constexpr typename Table::Pair pair = gaunt_table<N, K>.pairs[index];
    constexpr int l = pair.l, m = pair.m, k = pair.k, n = pair.n;
    constexpr int cosine = sh_index(l, m), sine = sh_index(l, -m), other = sh_index(k, n), other_sine = sh_index(k, -n);
    if constexpr (pair.first == pair.last) return;
    const C cosines = symmetric_product<cosine, other, C>(a, b);
    if constexpr (n == 0) {
      unroll<pair.first, pair.last>([&](auto t) ZONAL_INLINE { add(t, Index<m>{}, cosines); });
      if constexpr (m > 0) {
        const C sines = symmetric_product<sine, other, C>(a, b);
        unroll<pair.first, pair.last>([&](auto t) ZONAL_INLINE { add(t, Index<-m>{}, sines); });
      }
    } else {
      constexpr bool is_square = cosine == other;
      const C sines = symmetric_product<sine, other_sine, C>(a, b);
      const C mixed = symmetric_product<sine, other, C>(a, b);
      const C mixed_again = is_square ? mixed : symmetric_product<cosine, other_sine, C>(a, b);
      if constexpr (pair.first < pair.middle) {
        const C even = difference(cosines, sines), odd = is_square ? mixed : mixed + mixed_again;
        unroll<pair.first, pair.middle>([&](auto t) ZONAL_INLINE {
          add(t, Index<m + n>{}, even);
          add(t, Index<-m - n>{}, odd);
        });
      }
      if constexpr (pair.middle < pair.last) {
        const C even = cosines + sines;
        unroll<pair.middle, pair.last>([&](auto t) ZONAL_INLINE { add(t, Index<m - n>{}, even); });
        if constexpr (m > n) {
          const C odd = difference(mixed, mixed_again);
          unroll<pair.middle, pair.last>([&](auto t) ZONAL_INLINE { add(t, Index<n - m>{}, odd); });
        }
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
    constexpr typename Table::Term first = zonal_gaunt_table<N, Orders>.terms[pair.first];
    constexpr auto first_gaunt = rounded<Number>(first.value);
    Z factor = times(z.values[first.k], Number(first_gaunt));
    unroll<pair.first + 1, pair.last>([&](auto t) ZONAL_INLINE {
      constexpr typename Table::Term term = zonal_gaunt_table<N, Orders>.terms[t];
      constexpr auto gaunt = rounded<Number>(term.value);
      add_times(factor, z.values[term.k], Number(gaunt));
    });
    apply(Index<pair.l>{}, Index<pair.j>{}, Index<pair.m>{}, factor);
  });
}

// sums[to] = or += a[from] * factor: pairs begin with those of j = m, which is what each sum is first given.
template <bool is_first, int to, int from, class C, class A, class Z>
ZONAL_INLINE constexpr void add_zonal(C* sums, const A* a, const Z& factor) {
  if constexpr (is_first) {
    sums[to] = times(a[from], factor);
  } else {
    add_times(sums[to], a[from], factor);
  }
}

template <int N, class A, class Z>
ZONAL_INLINE constexpr Sh<N, product_t<A, Z>> product_by_gaunt(const Sh<N, A>& a, const Zh<N, Z>& z) {
  Sh<N, product_t<A, Z>> sums{};
  for_each_zonal_factor<N, N>(z, [&](auto l, auto j, auto m, const Z& factor) ZONAL_INLINE {
    constexpr int upper = sh_index(l, m), lower = sh_index(j, m);
    add_zonal<j == m, upper, lower>(sums.values, a.values, factor);
    if constexpr (l != j) add_zonal<false, lower, upper>(sums.values, a.values, factor);
    if constexpr (m > 0) {
      add_zonal<j == m, upper - 2 * m, lower - 2 * m>(sums.values, a.values, factor);
      if constexpr (l != j) add_zonal<false, lower - 2 * m, upper - 2 * m>(sums.values, a.values, factor);
    }
  });
  return sums;
}
template <int N, class A, class Z>
ZONAL_INLINE constexpr Zh<N, product_t<A, Z>> product_by_gaunt(const Zh<N, A>& a, const Zh<N, Z>& z) {
  Zh<N, product_t<A, Z>> sums{};
  for_each_zonal_factor<N, 1>(z, [&](auto l, auto j, auto, const Z& factor) ZONAL_INLINE {
    add_zonal<j == 0, l, j>(sums.values, a.values, factor);
    if constexpr (l != j) add_zonal<false, j, l>(sums.values, a.values, factor);
  });
  return sums;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
