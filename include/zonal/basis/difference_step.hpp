// Legendre functions by their differences: nothing is lost where the argument is next to 1.
//
// The m-th derivative of P_l(u) over its value at u = 1, R_l, follows with t = 1 - u from
//
//   R_m = 1,  d_m = 0,   R_l = R_(l-1) + d_l,   d_l = ((l-m-1) d_(l-1) - (2l-1) t R_(l-1)) / (l+m)
//
// which is the recurrence of Gegenbauer's polynomials less its value at u = 1. Who keeps u instead of t, or subtracts
// R_(l-2) from R_(l-1) in every step, has errors that grow as l^2 near 1.
#pragma once

#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

constexpr long double difference_of_step(int l, int m) { return (l - m - 1.0L) / (l + m); }
constexpr long double difference_of_sum(int l, int m) { return (2 * l - 1.0L) / (l + m); }

/// d_l from R_(l-1) and d_(l-1); with l-m-1 and 2l-1 for the factors, l+m times it.
template <class T>
ZONAL_INLINE constexpr T next_difference(const T& of_step, const T& of_sum, const T& t, const T& sum, const T& step) {
  return of_step * step - of_sum * (t * sum);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
