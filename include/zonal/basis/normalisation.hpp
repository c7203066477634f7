// The normalisation of the zonal harmonics, Y_l^0(u) = K_l P_l(u): the one home of what the lobes and transforms need.
#pragma once

#include "../scalar/constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// K_l = sqrt((2l+1) / (4 pi)).
constexpr long double zonal_normalisation_of(int l) { return constexpr_sqrt((2 * l + 1) / (4 * kPi)); }
template <int l>
inline constexpr long double zonal_normalisation = zonal_normalisation_of(l);

// 1 / K_l = sqrt(4 pi / (2l+1)): from a zonal coefficient to the factor of its degree.
constexpr long double zonal_to_degree_of(int l) { return constexpr_sqrt(4 * kPi / (2 * l + 1)); }
template <int l>
inline constexpr long double zonal_to_degree = zonal_to_degree_of(l);

// 2 pi K_l = sqrt(pi (2l+1)): from the integral of f(u) P_l(u) du to the zonal coefficient.
constexpr long double zonal_integral_of(int l) { return constexpr_sqrt(kPi * (2 * l + 1)); }
template <int l>
inline constexpr long double zonal_integral = zonal_integral_of(l);

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
