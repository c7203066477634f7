// Where an outgoing direction lies among the rows of a material's table, and what is read there, in any scalar.
#pragma once

#include "../scalar/math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// The place of the outgoing angle, whose cosine is in [-1, 1] up to rounding, in a table of so many rows, one a degree
/// from 0 on: 0 to rows - 1, the last of which also answers what is beyond it or no number. Greatest error 3e-5 rows.
template <class T>
ZONAL_INLINE constexpr T row_position(const T& cos_outgoing, const T& rows) {
  constexpr auto degrees_per_radian = rounded<T>(180 / kPi);
  const T degrees = acos(clamp(cos_outgoing, T(-1), T(1))) * T(degrees_per_radian), last = rows - T(1);
  return select(degrees < last, degrees, last);
}

/// A coefficient, number or colour, at t from 0 to 1 between those of two rows.
template <class T, class C>
ZONAL_INLINE constexpr C between_rows(const C& below, const C& above, const T& t) {
  return below + t * (above - below);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
