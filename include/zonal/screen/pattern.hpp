// Interleaved sampling: neighbouring pixels see different sets of lights, and together all of them.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination, section 2.3.
// [2] Keller and Heidrich, Interleaved sampling, EGWR 2001.
#pragma once

#include <string>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// `columns` x `rows` sets of lights: pixel (x, y) sees the set of (x mod columns, y mod rows).
struct InterleavedPattern {
  static constexpr int longest_side = 16;

  int columns = 4, rows = 4;

  constexpr int sets() const { return columns * rows; }
  constexpr int set_of(int x, int y) const { return y % rows * columns + x % columns; }

  /// Why it is no pattern for a picture of that size; empty if it is one.
  std::string what_is_wrong(int width, int height) const {
    const auto size = [](int a, int b) { return std::to_string(a) + "x" + std::to_string(b); };
    if (columns < 1 || rows < 1) return "a pattern of " + size(columns, rows) + " sets: at least 1x1";
    if (columns > longest_side || rows > longest_side) {
      return "a pattern of " + size(columns, rows) + " sets: at most " + size(longest_side, longest_side);
    }
    if (columns > width || rows > height) {
      return "a pattern of " + size(columns, rows) + " sets, larger than the picture, " + size(width, height);
    }
    return {};
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
