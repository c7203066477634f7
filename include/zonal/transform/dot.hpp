// Integrals of products, and values at a direction, which are sums of products.
#pragma once

#include "../basis/evaluate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// One accumulator would wait for each sum before the next; four keep the multipliers busy.
template <class T>
struct Accumulator {
  T part[4] = {T(0), T(0), T(0), T(0)};
  constexpr void add(int slot, const T& value) { part[slot % 4] = part[slot % 4] + value; }
  constexpr T sum() const { return (part[0] + part[1]) + (part[2] + part[3]); }
};
}  // namespace detail

/// The integral over the sphere of the product of two functions: the sum of the products of their coefficients.
template <int N, class A, class T>
constexpr auto dot(const Sh<N, A>& a, const Sh<N, T>& b) {
  detail::Accumulator<std::decay_t<decltype(a[0] * b[0])>> total;
  unroll<0, N * N>([&](auto i) ZONAL_INLINE { total.add(i, a.values[i] * b.values[i]); });
  return total.sum();
}
template <int N, class A, class T>
constexpr auto dot(const EvenSh<N, A>& a, const EvenSh<N, T>& b) {
  detail::Accumulator<std::decay_t<decltype(a[0] * b[0])>> total;
  unroll<0, N*(N + 1) / 2>([&](auto i) ZONAL_INLINE { total.add(i, a.values[i] * b.values[i]); });
  return total.sum();
}
template <int N, class A, class T>
constexpr auto dot(const Zh<N, A>& a, const Zh<N, T>& b) {
  detail::Accumulator<std::decay_t<decltype(a[0] * b[0])>> total;
  unroll<0, N>([&](auto i) ZONAL_INLINE { total.add(i, a.values[i] * b.values[i]); });
  return total.sum();
}

/// The function's value in a direction (a unit vector): basis and sum fused, nothing stored. T may be a colour.
template <int N, class T, class Direction>
constexpr T reconstruct(const Sh<N, T>& sh, const Direction& direction) {
  using S = component_t<Direction>;
  detail::Accumulator<T> total;
  evaluate<N>(S(direction[0]), S(direction[1]), S(direction[2]), [&](auto l, auto m, const S& y) ZONAL_INLINE {
    total.add(sh_index(l, m), sh.values[sh_index(l, m)] * y);
  });
  return total.sum();
}

/// A zonal function's value at an angle from its axis.
template <int N, class T, class S>
constexpr T reconstruct_zonal(const Zh<N, T>& zh, const S& cos_angle) {
  detail::Accumulator<T> total;
  evaluate_zonal<N>(cos_angle, [&](auto l, const S& y) ZONAL_INLINE { total.add(l, zh.values[l] * y); });
  return total.sum();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
