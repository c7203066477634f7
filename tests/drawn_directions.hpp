// Counts of drawn directions against the shares that a density gives, on cells of equal solid angle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "catch.hpp"
#include "chi_squared.hpp"

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

/// How probable counts so far from those expected are.
inline double chi_squared_probability(const std::vector<double>& counts, const std::vector<double>& expected) {
  const ChiSquared found(counts, expected);
  if (!found.counts_rest()) CHECK(found.rest <= 40);
  return found.freedom > 0 ? probability_above(found.statistic, found.freedom) : 1.0;
}

}  // namespace drawn
