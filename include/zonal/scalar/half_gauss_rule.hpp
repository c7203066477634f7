// Gauss-Legendre rules whose size is known at compile time; those of run time: quadrature.hpp.
#pragma once

#include <cstddef>

#include "constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The half with nodes[i] >= 0 of the rule of `Size` nodes, decreasing: the other half mirrors it. Computed at compile
/// time, to a few units of long double's last place; where Size is odd the last node is 0, which is its own mirror.
template <int Size>
struct HalfGaussRule {
  static_assert(Size >= 1, "a rule has at least one node");
  static constexpr int count = (Size + 1) / 2;
  long double nodes[static_cast<std::size_t>(count)] = {}, weights[static_cast<std::size_t>(count)] = {};

  constexpr HalfGaussRule() {
    for (int i = 0; i < count; ++i) {
      const bool is_middle = 2 * i + 1 == Size;
      long double x = is_middle ? 0 : cosine(kPi * (i + 0.75L) / (Size + 0.5L)), slope = 1;
      for (int iteration = 0; iteration < 5; ++iteration) {
        long double p = x, before = 1;
        for (int l = 2; l <= Size; ++l) {
          const long double next = ((2 * l - 1) * x * p - (l - 1) * before) / l;
          before = p;
          p = next;
        }
        slope = Size * (before - x * p) / (1 - x * x);
        if (!is_middle) x -= p / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }

 private:
  // cos(x), 0 <= x <= pi/2, as close as Newton's method has to start.
  static constexpr long double cosine(long double x) {
    long double term = 1, sum = 1;
    for (int k = 2; k <= 16; k += 2) {
      term *= -x * x / (k * (k - 1));
      sum += term;
    }
    return sum;
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
