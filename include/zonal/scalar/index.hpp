// From floats to indices of tables: the one way of this library to convert them.
#pragma once

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// The whole number at or below x, brought within 0 and `last`, 0 <= last <= 2^30; 0 for what is no number. To convert
/// a float that an int cannot hold, NaN too, is undefined behaviour, and an index out of nothing reads anywhere.
template <class T>
ZONAL_INLINE constexpr IfBuiltin<T, int> index_below(T x, int last) {
  const int below = static_cast<int>(minimum(maximum(T(0), x), static_cast<T>(last)));  // NaN is 0 by this order only
  return below < last ? below : last;  // from 2^24 on a float may count too many
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
