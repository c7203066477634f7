// Integrals of products, and values at a direction, which are sums of products.
#pragma once

#include "../basis/evaluate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// The sum of `Count` values. One accumulator would wait for each sum before the next; four keep the multipliers busy.
// T may be a colour, of which T(0) and T{} need not be black: each part starts with the first value that it is given,
// 0 to 3, and these come before the others of their part.
template <int Count, class T>
struct Accumulator {
  T part[4] = {};

  template <int i>
  ZONAL_INLINE constexpr void add(Index<i>, const T& value) {
    if constexpr (i < 4) {
      part[i] = value;
    } else {
      part[i % 4] = part[i % 4] + value;
    }
  }
  ZONAL_INLINE constexpr T sum() const {
    if constexpr (Count == 1) {
      return part[0];
    } else if constexpr (Count < 4) {
      T total = part[0] + part[1];
      if constexpr (Count == 3) total = total + part[2];
      return total;
    } else {
      return (part[0] + part[1]) + (part[2] + part[3]);
    }
  }
};

template <int Count, class A, class T>
ZONAL_INLINE constexpr product_t<A, T> sum_of_products(const A (&a)[std::size_t{Count}],
                                                       const T (&b)[std::size_t{Count}]) {
  Accumulator<Count, product_t<A, T>> total;
  unroll<0, Count>([&](auto i) ZONAL_INLINE { total.add(i, times(a[i], b[i])); });
  return total.sum();
}
}  // namespace detail

/// The integral over the sphere of the product of two functions: the sum of the products of their coefficients, one of
/// which may be colours.
template <int N, class A, class T>
constexpr detail::product_t<A, T> dot(const Sh<N, A>& a, const Sh<N, T>& b) {
  return detail::sum_of_products<N * N>(a.values, b.values);
}
template <int N, class A, class T>
constexpr detail::product_t<A, T> dot(const EvenSh<N, A>& a, const EvenSh<N, T>& b) {
  return detail::sum_of_products<N*(N + 1) / 2>(a.values, b.values);
}
template <int N, class A, class T>
constexpr detail::product_t<A, T> dot(const Zh<N, A>& a, const Zh<N, T>& b) {
  return detail::sum_of_products<N>(a.values, b.values);
}

/// The function's value in a direction (a unit vector): basis and sum fused, nothing stored. T may be a colour.
template <int N, class T, class Direction>
constexpr T reconstruct(const Sh<N, T>& sh, const Direction& direction) {
  using S = component_t<Direction>;
  detail::Accumulator<N * N, T> total;
  const auto v = detail::as_direction<S>(direction);
  evaluate<N>(v.x, v.y, v.z, [&](auto l, auto m, const S& y) ZONAL_INLINE {
    constexpr int i = sh_index(l, m);
    total.add(Index<i>{}, detail::times(sh.values[i], y));
  });
  return total.sum();
}

/// A zonal function's value at an angle from its axis.
template <int N, class T, class S>
constexpr T reconstruct_zonal(const Zh<N, T>& zh, const S& cos_angle) {
  detail::Accumulator<N, T> total;
  evaluate_zonal<N>(cos_angle, [&](auto l, const S& y) ZONAL_INLINE { total.add(l, detail::times(zh.values[l], y)); });
  return total.sum();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
