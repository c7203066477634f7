// Gauss-Legendre rules whose size is known at run time; those of compile time: half_gauss_rule.hpp.
//
// [1] NIST Digital Library of Mathematical Functions, sections 3.5(v) and 18.16(ii).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Nodes in (-1, 1), increasing, and their weights, which sum to 2: sum of weights[i] f(nodes[i]) is the
/// integral of f over [-1, 1], exactly for polynomials of degree 2 size - 1.
struct QuadratureRule {
  std::vector<double> nodes, weights;
};

/// The Gauss-Legendre rule of `size` nodes, 1 to 4096. Greatest error of a node: 1e-15; of a weight: 1e-13 of
/// itself. The nodes are the roots of P_size, by Newton's method from their asymptotic places [1]: of their angles, for
/// next to the ends the cosine no longer knows its own sine, on which the weight depends.
inline QuadratureRule gauss_legendre(int size) {
  const auto n = static_cast<std::size_t>(size);
  QuadratureRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
    double angle = double(kPi) * (double(i) + 0.75) / (double(size) + 0.5), slope = 1.0;
    for (int iteration = 0; iteration < 4; ++iteration) {  // quadratic: three suffice from an error of 0.05 / n
      // P_l by its differences (lobe/cap.hpp), exact where 1 - cos is small; by the angle, sin P_l' = l (d - t P_l).
      const double sine = std::sin(angle), half_sine = std::sin(angle / 2), t = 2.0 * half_sine * half_sine;
      double p = 1.0 - t, difference = -t;
      for (int l = 2; l <= size; ++l) {
        difference = (double(l - 1) * difference - double(2 * l - 1) * t * p) / double(l);
        p += difference;
      }
      slope = double(size) * (difference - t * p) / sine;
      angle -= p / slope;
    }
    rule.nodes[i] = -std::cos(angle);
    rule.nodes[n - 1 - i] = -rule.nodes[i];
    rule.weights[i] = rule.weights[n - 1 - i] = 2.0 / (slope * slope);
  }
  return rule;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
