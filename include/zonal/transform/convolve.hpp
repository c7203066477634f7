// Convolution with a zonal kernel: each degree scaled, sqrt(4 pi / (2l+1)) z_l f_l^m (Funk and Hecke).
#pragma once

#include "../basis/normalisation.hpp"
#include "../lobe/lambert.hpp"
#include "dot.hpp"
#include "orient.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// What degree l of a function is multiplied by. The clamped cosine's 1, 2/3, 1/4, 0, ... are rounded once.
template <int l, class S, int N, class T>
ZONAL_INLINE constexpr T degree_factor(const Zh<N, T>& kernel) {
  using Number = number_t<T>;
  constexpr auto to_degree = rounded<Number>(zonal_to_degree<l>);
  return times(Number(to_degree), kernel.values[l]);
}
template <int l, class S>
ZONAL_INLINE constexpr S degree_factor(LambertLobe) {
  constexpr auto factor = rounded<S>(2 * cosine_integral(l));
  return S(factor);
}
}  // namespace detail

/// (f * k)(w) = integral of f(w') k(angle between w and w'). With k = LambertLobe, radiance becomes E / pi. Either may
/// be of colours.
template <int N, class A, class T>
constexpr Sh<N, detail::product_t<A, T>> convolve(const Sh<N, A>& f, const Zh<N, T>& kernel) {
  Sh<N, detail::product_t<A, T>> r{};
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    const T factor = detail::degree_factor<l, T>(kernel);
    unroll<l * l, (l + 1) * (l + 1)>([&](auto i) ZONAL_INLINE { r.values[i] = detail::times(f.values[i], factor); });
  });
  return r;
}

/// The same of a zonal function; the result is zonal about the same axis.
template <int N, class A, class T>
constexpr Zh<N, detail::product_t<A, T>> convolve(const Zh<N, A>& f, const Zh<N, T>& kernel) {
  Zh<N, detail::product_t<A, T>> r{};
  unroll<0, N>([&](auto l)
                   ZONAL_INLINE { r.values[l] = detail::times(f.values[l], detail::degree_factor<l, T>(kernel)); });
  return r;
}

/// (f * k) in a direction, a unit vector: one factor per degree, nothing stored. T may be a colour; the kernel is a Zh
/// of as many bands, or LambertLobe, which gives E / pi.
template <int N, class T, class Kernel, class Direction>
constexpr T reconstruct_convolved(const Sh<N, T>& f, const Kernel& kernel, const Direction& direction) {
  using D = component_t<Direction>;
  Zh<N, T> by_degree{};
  const auto v = detail::as_direction<D>(direction);
  evaluate<N>(v.x, v.y, v.z, [&](auto l, auto m, const D& y) ZONAL_INLINE {
    constexpr int i = sh_index(l, m);
    if constexpr (m == 0) {  // the first of its degree
      by_degree.values[l] = detail::times(f.values[i], y);
    } else {
      by_degree.values[l] = by_degree.values[l] + detail::times(f.values[i], y);
    }
  });
  detail::Accumulator<N, T> total;
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    total.add(l, detail::times(by_degree.values[l], detail::degree_factor<l, D>(kernel)));
  });
  return total.sum();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
