// Counts of drawn directions against the shares that a density gives, on cells of equal solid angle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "catch.hpp"

namespace drawn {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr int rows = 24, columns = 48, cells = rows * columns;

inline int cell_of(double x, double y, double z) {
  const double turn = std::atan2(y, x) / (2 * pi);
  const int row = std::min(rows - 1, static_cast<int>((z + 1) / 2 * rows));
  const int column = std::min(columns - 1, static_cast<int>((turn < 0 ? turn + 1 : turn) * columns));
  return row * columns + column;
}

struct Direction {
  double x, y, z;
};

/// The place (u, v) of a cell, both in [0, 1].
inline Direction in_cell(int cell, double u, double v) {
  const double z = -1 + 2.0 / rows * (cell / columns + u), phi = 2 * pi / columns * (cell % columns + v);
  const double sine = std::sqrt((1 - z) * (1 + z));
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

/// The share of each cell: the density's mean over side x side places.
template <class Density>
std::vector<double> shares(int side, const Density& density) {
  std::vector<double> all(std::size_t{cells});
  for (int cell = 0; cell < cells; ++cell) {
    for (int i = 0; i < side * side; ++i) {
      const Direction d = in_cell(cell, (i / side + 0.5) / side, (i % side + 0.5) / side);
      all[std::size_t(cell)] += density(d) * 4 * pi / cells / (side * side);
    }
  }
  return all;
}

/// The share of chi-squared's distribution above `statistic`, by Wilson and Hilferty's approximation.
inline double probability_above(double statistic, double freedom) {
  const double variance = 2 / (9 * freedom);
  const double normal = (std::cbrt(statistic / freedom) - 1 + variance) / std::sqrt(variance);
  return 0.5 * std::erfc(normal / std::sqrt(2.0));
}

/// How probable counts so far from those expected are. Cells that are expected to have few count as one.
inline double chi_squared_probability(const std::vector<double>& counts, const std::vector<double>& expected) {
  constexpr double few = 10;
  double statistic = 0, rest = 0, rest_expected = 0;
  int freedom = -1;
  const auto add = [&](double count, double mean) {
    statistic += (count - mean) * (count - mean) / mean;
    ++freedom;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] >= few) {
      add(counts[i], expected[i]);
    } else {
      rest += counts[i], rest_expected += expected[i];
    }
  }
  if (rest_expected >= few) {
    add(rest, rest_expected);
  } else {
    CHECK(rest <= 4 * few);
  }
  return freedom > 0 ? probability_above(statistic, freedom) : 1.0;
}

}  // namespace drawn
