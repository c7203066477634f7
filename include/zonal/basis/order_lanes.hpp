// One direction of many bands: the orders m side by side in the lanes of a register, the degrees one after the other.
//
// For values in an array, at run time, from 16 bands on: with AVX2 at 16 bands three quarters of the time of one order
// after the other, at 20 half of it, at 24 two fifths. Below the columns of few degrees waste the lanes. The recurrence
// begins on the diagonal, where evaluate() has polynomials for the first three degrees above it, and powers of x + iy
// come from fewer products: results differ by roundings from those of the sink form; the greatest error is the same.
#pragma once

#include <cstddef>
#include <type_traits>

#include "../scalar/lanes.hpp"
#include "../scalar/unroll.hpp"
#include "sh.hpp"
#include "table.hpp"

// The targets and compilers that were measured: x86 with SSE2 or AVX2.
#if defined(__SSE2__) && (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 9)) && !defined(__CUDACC__)
#define ZONAL_ORDERS_IN_LANES
#endif

#if defined(ZONAL_ORDERS_IN_LANES)
namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

template <int N, class T>
inline constexpr bool are_orders_in_lanes = N >= 16 && (std::is_same_v<T, float> || std::is_same_v<T, double>);

// Wider registers than of 32 bytes would be half empty at these bands.
template <class T>
inline constexpr int order_lanes_v = native_lanes_v<T> * sizeof(T) > 32 ? 32 / sizeof(T) : native_lanes_v<T>;

// What the recurrence takes, order by order, in whole registers. Orders that have not begun have zeros; each begins
// with its diagonal, which is added: block l / width of degree l has it.
template <int N, class T>
struct OrderTable {
  static constexpr int width = order_lanes_v<T>, blocks = (N + width - 1) / width;
  static constexpr std::size_t size = N, padded = blocks * width;
  alignas(Lanes<T, width>) T raise[size][padded] = {};
  alignas(Lanes<T, width>) T lower[size][padded] = {};
  alignas(Lanes<T, width>) T diagonal[size][std::size_t{width}] = {};

  constexpr OrderTable() {
    for (int l = 0; l < N; ++l) {
      diagonal[l][l % width] = rounded<T>(basis_table<N>.diagonal[l]);
      for (int m = 0; m < l; ++m) {
        raise[l][m] = rounded<T>(basis_table<N>.raise[l][m]);
        lower[l][m] = rounded<T>(basis_table<N>.lower[l][m]);
      }
    }
  }
};
template <int N, class T>
inline constexpr OrderTable<N, T> order_table{};

// Blocks of orders: cos(m phi) and sin(m phi) times sin^m theta, q_l^m of the last degree and of the one below.
template <class T, int width, int blocks>
struct OrderLanes {
  using L = Lanes<T, width>;
  L c[std::size_t{blocks}], s[std::size_t{blocks}], last[std::size_t{blocks}], below[std::size_t{blocks}];

  ZONAL_INLINE OrderLanes(T x, T y) {
    T cosines[std::size_t{width}], sines[std::size_t{width}];
    T c_m = T(1), s_m = T(0);
    for (int m = 0; m < width; ++m) {
      cosines[m] = c_m;
      sines[m] = s_m;
      turn(x, y, c_m, s_m);
    }
    for (int b = 0; b < blocks; ++b) {
      c[b] = b == 0 ? L::load(cosines) : c[b - 1];
      s[b] = b == 0 ? L::load(sines) : s[b - 1];
      if (b > 0) turn(L(c_m), L(s_m), c[b], s[b]);
      last[b] = below[b] = L(0);
    }
  }
};

// Numbers first, first + step, ... of two blocks side by side; anything for those below 0.
template <int first, int step>
struct OrderWindow {
  static constexpr int at(int lane) { return first + step * lane < 0 ? 0 : first + step * lane; }
};

// Degree l from the two below it, to its place among the values. What is stored beyond the degree is overwritten by the
// next, and no store ends beyond the last.
template <int N, int l, class T, int width, int blocks>
ZONAL_INLINE inline void next_degree(const Lanes<T, width>& z, OrderLanes<T, width, blocks>& orders, T* values) {
  using L = Lanes<T, width>;
  constexpr auto& table = order_table<N, T>;
  constexpr int top = l / width, size = N * N;
  L up[std::size_t{blocks}], down[std::size_t{blocks}];  // of orders m and -m
  for (int b = 0; b <= top; ++b) {
    const L raise = L::load(table.raise[l] + b * width), lower = L::load(table.lower[l] + b * width);
    L q = next_legendre(raise, lower, z, orders.last[b], orders.below[b]);
    if (b == top) q = q + L::load(table.diagonal[l]);
    orders.below[b] = orders.last[b];
    orders.last[b] = q;
    up[b] = q * orders.c[b];
    down[b] = q * orders.s[b];
  }
  // -l, 1 - l, ...: the orders from l downwards.
  unroll<0, top + 1>([&](auto k) ZONAL_INLINE {
    constexpr int m = l - k * width, high = m / width, low = high > 0 ? high - 1 : 0;
    static_assert(sh_index(l, -m) + width <= size, "a store beyond the values");
    L::template shuffle<OrderWindow<m - low * width, -1>>(down[low], down[high]).store(values + sh_index(l, -m));
  });
  for (int b = 0; b < top; ++b) up[b].store(values + sh_index(l, b * width));
  if constexpr (sh_index(l, top * width) + width <= size) {
    up[top].store(values + sh_index(l, top * width));
  } else {  // of the last degree what fills a register up to the end
    constexpr int m = l - width + 1, low = m / width;
    L::template shuffle<OrderWindow<m - low * width, 1>>(up[low], up[top]).store(values + sh_index(l, m));
  }
}

template <int N, class T>
ZONAL_INLINE inline void evaluate_orders(Sh<N, T>& sh, T x, T y, T z) {
  constexpr int width = order_lanes_v<T>;
  OrderLanes<T, width, OrderTable<N, T>::blocks> orders(x, y);
  const Lanes<T, width> z_lanes(z);
  unroll<0, N>([&](auto l) ZONAL_INLINE { next_degree<N, l>(z_lanes, orders, sh.values); });
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
#endif
