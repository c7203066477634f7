// The zonal coefficients of a spherical cap as the papers have them, from Legendre polynomials: the slow reference.
//
// z_l = sqrt(pi / (2l+1)) (P_(l-1)(cos a) - P_(l+1)(cos a)) for l >= 1, z_0 = sqrt(pi) (1 - cos a)     [1] Eq. 14
//
// with the plain recurrence (l+1) P_(l+1) = (2l+1) cos a P_l - l P_(l-1), its constants folded. For a small cap both
// polynomials are near 1 and the difference cancels: in float the error is 7 % at a = 1e-3, and at 1e-4 nothing is
// left. project (cap.hpp) is the form without cancellation.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
#pragma once

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace reference {

/// z_l of the indicator of the cap of all directions within an angle of the axis, N >= 1, from the cosine of that
/// angle, -1 to 1.
template <int N, class T>
constexpr Zh<N, T> project_cap_legendre(const T& cos_angle) {
  Zh<N, T> zh{};
  constexpr auto scale_0 = rounded<T>(zonal::detail::zonal_integral<0>);
  zh[0] = T(scale_0) * (T(1) - cos_angle);
  [[maybe_unused]] T before = T(1), p = cos_angle;  // P_(l-1), P_l
  unroll<1, N>([&](auto l) {
    constexpr auto of_last = rounded<T>((2 * l + 1.0L) / (l + 1)), of_before = rounded<T>(1.0L * l / (l + 1));
    constexpr auto scale = rounded<T>(zonal::detail::zonal_integral<l> / (2 * l + 1));
    const T next = T(of_last) * cos_angle * p - T(of_before) * before;
    zh[l] = T(scale) * (before - next);
    before = p;
    p = next;
  });
  return zh;
}

}  // namespace reference
}  // namespace ZONAL_TARGET
}  // namespace zonal
