#pragma once

#include <cstdint>

#include "texture.hpp"

namespace example {

/// Heights between 0 and 1 of a square that repeats: value noise of `cells` cells across, and of octaves above it, each
/// of twice the cells and half the height. cells 2^(octaves - 1) at most size.
Texture noise_heights(int size, int cells, int octaves, std::uint64_t seed);

}  // namespace example
