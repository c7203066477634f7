// Convolution with a zonal kernel: each degree scaled, sqrt(4 pi / (2l+1)) z_l f_l^m (Funk and Hecke).
#pragma once

#include "dot.hpp"
#include "orient.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// (f * k)(w) = integral of f(w') k(angle between w and w'). With k = LambertLobe, radiance becomes E / pi.
template <int N, class A, class T>
constexpr Sh<N, A> convolve(Sh<N, A> f, const Zh<N, T>& kernel) {
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    const T factor = T(detail::zonal_to_degree(l)) * kernel.values[l];
    unroll<l * l, (l + 1) * (l + 1)>([&](auto i) ZONAL_INLINE { f.values[i] = f.values[i] * factor; });
  });
  return f;
}

/// The same of a zonal function; the result is zonal about the same axis.
template <int N, class A, class T>
constexpr Zh<N, A> convolve(Zh<N, A> f, const Zh<N, T>& kernel) {
  unroll<0, N>([&](auto l)
                   ZONAL_INLINE { f.values[l] = f.values[l] * (T(detail::zonal_to_degree(l)) * kernel.values[l]); });
  return f;
}

/// (f * k) in a direction, a unit vector: one factor per degree, nothing stored. T may be a colour.
template <int N, class T, class S, class Direction>
constexpr T reconstruct_convolved(const Sh<N, T>& f, const Zh<N, S>& kernel, const Direction& direction) {
  using D = component_t<Direction>;
  Zh<N, T> by_degree{};
  evaluate<N>(D(direction[0]), D(direction[1]), D(direction[2]), [&](auto l, auto m, const D& y) ZONAL_INLINE {
    by_degree.values[l] = by_degree.values[l] + f.values[sh_index(l, m)] * y;
  });
  detail::Accumulator<T> total;
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    total.add(l, by_degree.values[l] * (S(detail::zonal_to_degree(l)) * kernel.values[l]));
  });
  return total.sum();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
