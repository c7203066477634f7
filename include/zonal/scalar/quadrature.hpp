// Gauss-Legendre rules whose size is known at run time.
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
/// itself. The nodes are the roots of P_size, by Newton's method from their asymptotic places [1].
inline QuadratureRule gauss_legendre(int size) {
  const auto n = static_cast<std::size_t>(size);
  QuadratureRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
    double x = std::cos(double(kPi) * (double(i) + 0.75) / (double(size) + 0.5));
    double derivative = 1.0;
    for (int iteration = 0; iteration < 4; ++iteration) {  // quadratic: three suffice from an error of 0.01 / n
      double previous = 1.0, p = x;
      for (int l = 2; l <= size; ++l) {
        const double next = x * p + double(l - 1) / double(l) * (x * p - previous);
        previous = p;
        p = next;
      }
      derivative = double(size) * (previous - x * p) / ((1.0 - x) * (1.0 + x));
      x -= p / derivative;
    }
    rule.nodes[i] = -x;
    rule.nodes[n - 1 - i] = x;
    rule.weights[i] = rule.weights[n - 1 - i] = 2.0 / ((1.0 - x) * (1.0 + x) * derivative * derivative);
  }
  return rule;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
