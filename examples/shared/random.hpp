#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace example {

/// A well-mixed 64-bit hash (the finaliser of SplitMix64).
inline std::uint64_t hash64(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ull;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
  return value ^ (value >> 31);
}

/// The upper 24 bits as a float in [0, 1), exactly.
inline float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// PCG32 (O'Neill 2014). Seeded by what is sampled, not by who samples it: results do not depend on the
/// number of threads.
class Pcg32 {
 public:
  explicit Pcg32(std::uint64_t seed) : state_(hash64(seed)), increment_(hash64(~seed) | 1u) {}

  std::uint32_t bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return (mixed >> turn) | (mixed << ((32u - turn) & 31u));
  }

  float uniform() { return unit_float(bits()); }

  glm::vec2 uniform2() {
    const float first = uniform();
    return {first, uniform()};
  }

 private:
  std::uint64_t state_;
  std::uint64_t increment_;
};

/// Three well-spread coordinates per index: the (0,2)-sequence of van der Corput and Sobol, and a
/// golden-ratio sequence, each shifted at random (Kollig and Keller 2002).
class SpreadPoints {
 public:
  explicit SpreadPoints(Pcg32& random)
      : scramble_x_(random.bits()), scramble_y_(random.bits()), offset_(random.bits()) {}

  glm::vec2 point(std::uint32_t index) const {
    return {unit_float(van_der_corput(index) ^ scramble_x_), unit_float(sobol(index) ^ scramble_y_)};
  }

  float choice(std::uint32_t index) const { return unit_float(offset_ + index * 2654435769u); }

 private:
  static std::uint32_t van_der_corput(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
    bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
    return ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
  }

  static std::uint32_t sobol(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
      if (index & 1u) result ^= direction;
    }
    return result;
  }

  std::uint32_t scramble_x_;
  std::uint32_t scramble_y_;
  std::uint32_t offset_;
};

}  // namespace example
