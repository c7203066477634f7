// What lights and receivers are sorted by.
#pragma once

#include <cmath>
#include <limits>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// x itself, and all that are no numbers alike, below the others. By `<` alone these equal every number, which is no
/// order, and to sort by what is none may read beyond the array.
inline float sort_key(float x) { return std::isnan(x) ? -std::numeric_limits<float>::infinity() : x; }

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
