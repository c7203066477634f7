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

}  // namespace example
