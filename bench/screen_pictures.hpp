// What the screen's filter is timed on.
#pragma once

#include <array>

namespace zonal_bench {

/// A plane seen at a slant, 1280x720; or the same broken into other meshes every 40 pixels.
struct ScreenCase {
  const char* name;
  int sets_side, broken_every;  // 0: nowhere
};
inline constexpr std::array<ScreenCase, 4> screen_cases{
    {{"4x4", 4, 0}, {"4x4-broken", 4, 40}, {"8x8", 8, 0}, {"8x8-broken", 8, 40}}};
inline constexpr int screen_bands = 3;

}  // namespace zonal_bench
