// Well-spread points in four dimensions.
//
// Sobol's sequence is a (t, s)-sequence in base 2: each run of 2^m points that begins at a multiple of 2^m has 2^t in
// every box of volume 2^(t - m) whose sides are whole parts of powers of two. t is 0 for the first two dimensions, 1
// for the first three, 3 for all four. Owen's scrambling turns each box's inside at random and keeps all of this.
//
// What depends on several coordinates at once must take them from one point: two scramblings of the same coordinates
// are not two more dimensions, for the boxes of one fix those of the other, and its mean does not converge. Integrals
// that are only added may each have a sequence of their own.
//
// [1] Joe and Kuo, Constructing Sobol sequences with better two-dimensional projections, 2008: new-joe-kuo-6.
// [2] Owen, Randomly permuted (t, m, s)-nets and (t, s)-sequences, 1995.
// [3] Laine and Karras, Stratified sampling for stochastic transparency, 2011; the multipliers are Vegdahl's, 2021.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

#include "random.hpp"

namespace example {
namespace detail {

using SobolMatrix = std::array<std::uint32_t, 32>;  // of a dimension: what each bit of the index adds

/// From a primitive polynomial's degree, its inner coefficients as bits, and the first numbers [1].
constexpr SobolMatrix sobol_matrix(int degree, unsigned coefficients, const std::array<std::uint32_t, 3>& first) {
  SobolMatrix v{};
  for (int i = 0; i < 32; ++i) {
    if (i < degree) {
      v[std::size_t(i)] = first[std::size_t(i)] << (31 - i);
      continue;
    }
    const std::uint32_t last = v[std::size_t(i - degree)];
    v[std::size_t(i)] = last ^ (last >> degree);
    for (int k = 1; k < degree; ++k) {
      if ((coefficients >> (degree - 1 - k) & 1u) != 0) v[std::size_t(i)] ^= v[std::size_t(i - k)];
    }
  }
  return v;
}

constexpr SobolMatrix van_der_corput_matrix() {
  SobolMatrix v{};
  for (int i = 0; i < 32; ++i) v[std::size_t(i)] = 1u << (31 - i);
  return v;
}

inline constexpr std::array<SobolMatrix, 4> sobol_matrices{van_der_corput_matrix(), sobol_matrix(1, 0, {1}),
                                                           sobol_matrix(2, 1, {1, 3}), sobol_matrix(3, 1, {1, 3, 1})};

constexpr std::uint32_t reversed_bits(std::uint32_t bits) {
  bits = (bits << 16) | (bits >> 16);
  bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
  bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
  bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
  return ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
}

/// Each bit is turned or not by a hash of those above it [2, 3].
constexpr std::uint32_t owen_scrambled(std::uint32_t bits, std::uint32_t seed) {
  bits = reversed_bits(bits);
  bits ^= bits * 0x3d20adeau;
  bits += seed;
  bits *= (seed >> 16) | 1u;
  bits ^= bits * 0x05526c56u;
  bits ^= bits * 0x53a22864u;
  return reversed_bits(bits);
}

}  // namespace detail

class SpreadPoints {
 public:
  static constexpr int dimensions = 4;

  explicit SpreadPoints(Pcg32& random) {
    for (std::uint32_t& seed : seeds_) seed = random.bits();
  }

  /// In [0, 1). Of the coordinates the first two are spread best, then the first three.
  glm::vec4 point(std::uint32_t index) const {
    std::array<std::uint32_t, dimensions> bits{};
    for (std::size_t bit = 0; index != 0; index >>= 1, ++bit) {
      if ((index & 1u) == 0) continue;
      for (std::size_t i = 0; i < dimensions; ++i) bits[i] ^= detail::sobol_matrices[i][bit];
    }
    glm::vec4 point;
    for (int i = 0; i < dimensions; ++i) {
      point[i] = unit_float(detail::owen_scrambled(bits[std::size_t(i)], seeds_[std::size_t(i)]));
    }
    return point;
  }

 private:
  std::array<std::uint32_t, dimensions> seeds_{};
};

}  // namespace example
