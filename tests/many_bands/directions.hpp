// Directions for many bands: half of them near poles, down to where a sine's square is no number.
#pragma once

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../basis/directions.hpp"

/// Unit vectors in T, from a fixed seed: half uniform, half at a sine of 1 down to the least normal number; the six
/// axes.
template <class T>
std::vector<Vector3<T>> directions_to_poles(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  std::vector<Vector3<T>> directions;
  const double digits = -std::log10(static_cast<double>((std::numeric_limits<T>::min)()));
  for (int i = 0; i < count; ++i) {
    if (i % 2 == 0) {
      const double x = normal(random), y = normal(random), z = normal(random);
      directions.push_back(normalized(static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)));
      continue;
    }
    // Half of these within six decades, where the harmonics change most.
    const double sine = std::pow(10.0, -uniform(random) * (i % 4 == 1 ? 6 : digits)),
                 phi = 2 * 3.14159265358979 * uniform(random);
    const double z = std::sqrt((1 - sine) * (1 + sine)) * (i % 8 < 4 ? 1 : -1);
    directions.push_back(
        {static_cast<T>(sine * std::cos(phi)), static_cast<T>(sine * std::sin(phi)), static_cast<T>(z)});
  }
  for (const T sign : {T(1), T(-1)}) {
    directions.push_back({sign, 0, 0});
    directions.push_back({0, sign, 0});
    directions.push_back({0, 0, sign});
  }
  return directions;
}
