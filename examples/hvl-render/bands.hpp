#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace example::hvl_render {

/// What --bands and --emission-bands offer. Each pair is a kernel of its own, a second of compile time and
/// more, and that for each horizon, which has a source file of its own.
inline constexpr std::array compiled_bands{1, 2, 3, 4, 5, 7, 9};
inline constexpr std::array compiled_emission_bands{1, 3, 5};
/// What --bands offers to the zonal gather, where a band costs little.
inline constexpr std::array compiled_zonal_bands{3, 5, 7, 9, 15, 21};

template <std::size_t Size>
constexpr bool contains(const std::array<int, Size>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// What --bands offers to --tolerance: a plan has several kernels for each pair.
#ifdef ZONAL_QUICK
inline constexpr std::array compiled_planned_bands{5};
#else
inline constexpr std::array compiled_planned_bands{3, 5, 9};
#endif

}  // namespace example::hvl_render
