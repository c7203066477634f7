#include "noise.hpp"

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace example {
namespace {

/// Random values at the corners of a square's cells, smooth between them.
class Octave {
 public:
  Octave(int cells, std::mt19937_64& random) : cells_(cells) {
    constexpr double whole = 18446744073709551616.0;  // 2^64
    for (int i = 0; i < cells * cells; ++i)
      corners_.push_back(static_cast<float>(static_cast<double>(random()) / whole));
  }

  float at(const glm::vec2& place) const {
    const glm::vec2 scaled = place * static_cast<float>(cells_), cell = glm::floor(scaled), t = scaled - cell;
    const glm::vec2 smooth = t * t * t * (t * (6.0f * t - 15.0f) + 10.0f);
    const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
    return glm::mix(glm::mix(corner(x, y), corner(x + 1, y), smooth.x),
                    glm::mix(corner(x, y + 1), corner(x + 1, y + 1), smooth.x), smooth.y);
  }

 private:
  float corner(int x, int y) const { return corners_[static_cast<std::size_t>(y % cells_ * cells_ + x % cells_)]; }

  int cells_;
  std::vector<float> corners_;
};

}  // namespace

Texture noise_heights(int size, int cells, int octaves, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<float> heights(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0f);
  const float sum = 2.0f - std::exp2(1.0f - static_cast<float>(octaves));
  for (int i = 0; i < octaves; ++i) {
    const Octave octave(cells << i, random);
    const float share = std::exp2(-static_cast<float>(i)) / sum;
    std::size_t texel = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        heights[texel++] += share * octave.at((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
      }
    }
  }
  return {size, size, 1, std::move(heights)};
}

}  // namespace example
