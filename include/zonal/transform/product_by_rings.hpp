// Products of many bands, by a transform: to Gauss rings of constant z, where functions are Fourier series in phi, and
// back. Exact, with some N^3 operations in place of N^5.
//
// On a ring a function is sum over m of c_m cos(m phi) + s_m sin(m phi), with c_m = sum over l of f_l^m p_l^m(z). Two
// series are multiplied as such: to 20 bands that takes no more operations than to go on to a uniform grid in phi and
// back, a quarter of a period at a time.
#pragma once

#include <cstddef>

#include "../basis/sh.hpp"
#include "../scalar/colour.hpp"
#include "../scalar/unroll.hpp"
#include "gaunt.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// What a table that is read at run time holds: of packets a lane, else what constant_t says.
template <class T, class = void>
struct TableNumber {
  using Type = constant_t<T>;
};
template <class T>
struct TableNumber<T, std::void_t<decltype(T::width)>> {
  using Type = lane_t<T>;
};

// p_l^m at the rings, and with the weights of the integrals by z and phi: of a product's series, twice too large.
template <int N, int K, class S>
struct RingTable {
  static constexpr int rings = gaunt_nodes(N, K);
  S forward[static_cast<std::size_t>(rings)][static_cast<std::size_t>(even_index(N, 0))] = {};
  S back[static_cast<std::size_t>(rings)][static_cast<std::size_t>(even_index(K, 0))] = {};

  constexpr RingTable() {
    const LegendreGrid<K, rings> grid;
    for (int i = 0; i < rings; ++i) {
      const bool is_above = i < grid.count;
      const int at = is_above ? i : rings - 1 - i;
      const long double weight = 2 * at + 1 == rings ? grid.weights[at] : grid.weights[at] / 2;
      for (int l = 0; l < K; ++l) {
        for (int m = 0; m <= l; ++m) {
          const int index = even_index(l, m);
          const long double p = is_above || is_even_in_z(l, m) ? grid.values[at][index] : -grid.values[at][index];
          if (l < N) forward[i][index] = static_cast<S>(p);
          back[i][index] = static_cast<S>(p * weight * (m == 0 ? kPi : kPi / 2));
        }
      }
    }
  }
};
template <class Table>
inline constexpr Table ring_table{};

template <int N, class T>
struct FourierSeries {
  T cosines[static_cast<std::size_t>(N)], sines[static_cast<std::size_t>(N)];  // sines[0] is whatever it is
};

// Loops are written out up to so many bands of the result: sums then stay in registers. Beyond, they are loops.
inline constexpr int written_out_bands = 12;

// Bounds of loops that are written out, or are not; and their sums and differences.
template <bool is_written_out, int i>
ZONAL_INLINE constexpr auto bound() {
  if constexpr (is_written_out) {
    return Index<i>{};
  } else {
    return i;
  }
}
template <class I, class J>
ZONAL_INLINE constexpr auto plus(I i, J j) {
  if constexpr (std::is_empty_v<I> && std::is_empty_v<J>) {
    return Index<I::value + J::value>{};
  } else {
    return int{i} + int{j};
  }
}
template <class I, class J>
ZONAL_INLINE constexpr auto minus(I i, J j) {
  if constexpr (std::is_empty_v<I> && std::is_empty_v<J>) {
    return Index<I::value - J::value>{};
  } else {
    return int{i} - int{j};
  }
}
template <class Begin, class End, class F>
ZONAL_INLINE constexpr void for_each_index(Begin begin, End end, F&& body) {
  if constexpr (std::is_empty_v<Begin> && std::is_empty_v<End>) {
    unroll<Begin::value, End::value>(body);
  } else {
    for (int i = begin; i < int{end}; ++i) body(i);
  }
}

// A function on a ring, `legendre` being p_l^m there.
template <bool is_written_out, int N, class T, class S>
ZONAL_INLINE constexpr FourierSeries<N, T> on_ring(const Sh<N, T>& f, const S* legendre) {
  FourierSeries<N, T> series{};
  constexpr auto one = bound<is_written_out, 1>();
  constexpr auto end = bound<is_written_out, N>();
  for_each_index(bound<is_written_out, 0>(), end, [&](auto m) ZONAL_INLINE {
    const number_t<T> diagonal(legendre[even_index(m, m)]);
    T cosine = times(f.values[sh_index(m, m)], diagonal);
    T sine = m > 0 ? T(times(f.values[sh_index(m, -m)], diagonal)) : cosine;
    for_each_index(plus(m, one), end, [&](auto l) ZONAL_INLINE {
      const number_t<T> p(legendre[even_index(l, m)]);
      add_times(cosine, f.values[sh_index(l, m)], p);
      if (m > 0) add_times(sine, f.values[sh_index(l, -m)], p);
    });
    series.cosines[m] = cosine;
    series.sines[m] = sine;
  });
  return series;
}

// Twice the product of two series, to sink(k, cosine, sine), k < K:
//   2 cos m cos n = cos(m-n) + cos(m+n), 2 sin m sin n = cos(m-n) - cos(m+n), 2 sin m cos n = sin(m+n) + sin(m-n).
template <bool is_written_out, int K, class C, int N, class A, class B, class Sink>
ZONAL_INLINE constexpr void multiply_series(const FourierSeries<N, A>& a, const FourierSeries<N, B>& b, Sink&& sink) {
  constexpr auto one = bound<is_written_out, 1>();
  constexpr auto bands = bound<is_written_out, N>();
  const A a0 = a.cosines[0] + a.cosines[0];
  const B b0 = b.cosines[0] + b.cosines[0];

  C mean = times(a0, b.cosines[0]);
  if constexpr (N > 1) {
    C other = times(a.sines[1], b.sines[1]);
    add_times(mean, a.cosines[1], b.cosines[1]);
    for_each_index(bound<is_written_out, 2>(), bands, [&](auto n) ZONAL_INLINE {
      add_times(mean, a.cosines[n], b.cosines[n]);
      add_times(other, a.sines[n], b.sines[n]);
    });
    mean = mean + other;
  }
  sink(bound<is_written_out, 0>(), mean, mean);

  // Four sums at a time keep the multipliers busy: c + d for the cosine, s + t for the sine.
  const auto add_sum = [&](C& c, C& d, C& s, C& t, int m, int n) ZONAL_INLINE {
    add_times(c, a.cosines[m], b.cosines[n]);
    subtract_times(d, a.sines[m], b.sines[n]);
    add_times(s, a.sines[m], b.cosines[n]);
    add_times(t, a.cosines[m], b.sines[n]);
  };
  for_each_index(one, bands, [&](auto k) ZONAL_INLINE {
    C c = times(a0, b.cosines[k]), d = times(a.cosines[k], b0), s = times(a0, b.sines[k]), t = times(a.sines[k], b0);
    for_each_index(one, minus(bands, k), [&](auto n) ZONAL_INLINE {
      add_times(c, a.cosines[n + k], b.cosines[n]);
      add_times(d, a.cosines[n], b.cosines[n + k]);
      add_times(c, a.sines[n + k], b.sines[n]);
      add_times(d, a.sines[n], b.sines[n + k]);
      add_times(s, a.sines[n + k], b.cosines[n]);
      add_times(t, a.cosines[n], b.sines[n + k]);
      subtract_times(s, a.sines[n], b.cosines[n + k]);
      subtract_times(t, a.cosines[n + k], b.sines[n]);
    });
    for_each_index(one, k, [&](auto n) ZONAL_INLINE { add_sum(c, d, s, t, k - n, n); });
    sink(k, C(c + d), C(s + t));
  });
  for_each_index(bands, bound<is_written_out, K>(), [&](auto k) ZONAL_INLINE {
    const int n = k - N + 1;
    C c = times(a.cosines[N - 1], b.cosines[n]), s = times(a.sines[N - 1], b.cosines[n]);
    C d = times(C(times(a.sines[N - 1], b.sines[n])), number_t<C>(-1)), t = times(a.cosines[N - 1], b.sines[n]);
    for_each_index(minus(k, bound<is_written_out, N - 2>()), bands,
                   [&](auto i) ZONAL_INLINE { add_sum(c, d, s, t, k - i, i); });
    sink(k, C(c + d), C(s + t));
  });
}

// Adds what a ring gives to all coefficients of order k.
template <int K, class C, class S, class Order>
ZONAL_INLINE constexpr void add_ring(Sh<K, C>& sums, bool is_first, const S* back, Order k, const C& cosine,
                                     const C& sine) {
  constexpr bool is_written_out = std::is_empty_v<Order>;
  for_each_index(k, bound<is_written_out, K>(), [&](auto l) ZONAL_INLINE {
    const number_t<C> p(back[even_index(l, k)]);
    C& even = sums.values[sh_index(l, k)];
    C& odd = sums.values[sh_index(l, -k)];
    if (is_first) {
      even = times(cosine, p);
      if (k > 0) odd = times(sine, p);
    } else {
      add_times(even, cosine, p);
      if (k > 0) add_times(odd, sine, p);
    }
  });
}

// The K bands of a b.
template <int K, int N, class A, class B>
ZONAL_INLINE constexpr Sh<K, product_t<A, B>> product_by_rings(const Sh<N, A>& a, const Sh<N, B>& b) {
  using C = product_t<A, B>;
  using Table = RingTable<N, K, typename TableNumber<number_t<C>>::Type>;
  constexpr const Table& table = ring_table<Table>;
  constexpr bool is_written_out = K <= written_out_bands;
  Sh<K, C> sums{};
  for (int ring = 0; ring < Table::rings; ++ring) {
    const FourierSeries<N, A> on_a = on_ring<is_written_out>(a, table.forward[ring]);
    const FourierSeries<N, B> on_b = on_ring<is_written_out>(b, table.forward[ring]);
    multiply_series<is_written_out, K, C>(on_a, on_b, [&](auto k, const C& cosine, const C& sine) ZONAL_INLINE {
      add_ring(sums, ring == 0, table.back[ring], k, cosine, sine);
    });
  }
  return sums;
}
// The first N bands of a z.
template <int N, class A, class Z>
ZONAL_INLINE constexpr Sh<N, product_t<A, Z>> product_by_rings(const Sh<N, A>& a, const Zh<N, Z>& z) {
  using C = product_t<A, Z>;
  using Table = RingTable<N, N, typename TableNumber<number_t<C>>::Type>;
  constexpr const Table& table = ring_table<Table>;
  constexpr bool is_written_out = N <= written_out_bands;
  Sh<N, C> sums{};
  for (int ring = 0; ring < Table::rings; ++ring) {
    const FourierSeries<N, A> on_a = on_ring<is_written_out>(a, table.forward[ring]);
    Z on_z = times(z.values[0], number_t<Z>(table.forward[ring][0]));
    for (int l = 1; l < N; ++l) add_times(on_z, z.values[l], number_t<Z>(table.forward[ring][even_index(l, 0)]));
    on_z = on_z + on_z;  // the way back halves it
    for_each_index(bound<is_written_out, 0>(), bound<is_written_out, N>(), [&](auto m) ZONAL_INLINE {
      add_ring(sums, ring == 0, table.back[ring], m, C(times(on_a.cosines[m], on_z)), C(times(on_a.sines[m], on_z)));
    });
  }
  return sums;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
