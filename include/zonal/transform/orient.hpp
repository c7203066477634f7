// Turning a zonal lobe to any axis.
//
// f_l^m = sqrt(4 pi / (2l+1)) z_l Y_l^m(axis): N^2 multiplications beyond evaluating the basis, and no rotation matrix.
//
// [1] Sloan, Luna, Snyder, Local, deformable precomputed radiance transfer (SLS05), 2005.
#pragma once

#include "../basis/evaluate.hpp"
#include "../basis/normalisation.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The lobe's symmetry axis moved from z to `axis`, a unit vector: to sink(l, m, value) [1]. The
/// coefficients may be colours.
template <int N, class C, class T, class Sink>
ZONAL_INLINE constexpr void orient(const Zh<N, C>& zh, const T& x, const T& y, const T& z, Sink&& sink) {
  Zh<N, C> factor = zh;
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    constexpr auto to_degree = rounded<T>(detail::zonal_to_degree<l>);
    factor.values[l] = detail::times(T(to_degree), zh.values[l]);
  });
  evaluate<N>(x, y, z,
              [&](auto l, auto m, const T& value) ZONAL_INLINE { sink(l, m, detail::times(factor.values[l], value)); });
}

/// The same as an array; `axis` is anything with axis[0], axis[1], axis[2], or axis.x, axis.y, axis.z.
template <int N, class T, class Direction>
ZONAL_DEVICE constexpr Sh<N, T> orient(const Zh<N, T>& zh, const Direction& axis) {
  Sh<N, T> sh;
  const auto v = detail::as_direction<detail::number_t<T>>(axis);
  orient(zh, v.x, v.y, v.z, [&](auto l, auto m, const auto& value) ZONAL_INLINE { sh.values[sh_index(l, m)] = value; });
  return sh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
