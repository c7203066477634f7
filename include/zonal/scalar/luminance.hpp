// How much red, green and blue add to a colour's brightness.
#pragma once

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Weights of linear red, green and blue in luminance, ITU-R BT.709; their sum is 1.
inline constexpr double kLuminanceWeights[3] = {0.2126, 0.7152, 0.0722};

}  // namespace ZONAL_TARGET
}  // namespace zonal
