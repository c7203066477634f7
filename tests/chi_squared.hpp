// How far counts are from those expected.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

/// Over the bins that expect at least 10, the others together as one if they expect as many. The statistic's mean is
/// the degrees of freedom f, its variance 2 f.
struct ChiSquared {
  static constexpr double few = 10;
  double statistic = 0, rest = 0, rest_expected = 0;
  int freedom = -1;

  ChiSquared(const std::vector<double>& counts, const std::vector<double>& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] >= few) {
        add(counts[i], expected[i]);
      } else {
        rest += counts[i];
        rest_expected += expected[i];
      }
    }
    if (counts_rest()) add(rest, rest_expected);
  }
  bool counts_rest() const { return rest_expected >= few; }

 private:
  void add(double count, double mean) {
    statistic += (count - mean) * (count - mean) / mean;
    ++freedom;
  }
};

/// The share of chi-squared's distribution above `statistic`, by Wilson and Hilferty's approximation.
inline double probability_above(double statistic, double freedom) {
  const double variance = 2 / (9 * freedom);
  const double normal = (std::cbrt(statistic / freedom) - 1 + variance) / std::sqrt(variance);
  return 0.5 * std::erfc(normal / std::sqrt(2.0));
}
