// Directions and degrees that the tests of the basis share.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

template <class T>
using Vector3 = std::array<T, 3>;

template <class T>
Vector3<T> normalized(T x, T y, T z) {
  const T length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

/// Unit vectors in T, from a fixed seed: half of them uniform over the sphere, half at 1e-1 to 1e-7 from a pole; and
/// the six axes.
template <class T>
std::vector<Vector3<T>> directions_and_poles(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const double pi = 3.14159265358979323846;
  std::vector<Vector3<T>> directions;
  const auto add = [&](double x, double y, double z) {
    directions.push_back({static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)});
  };
  for (int i = 0; i < count; ++i) {
    if (i % 2 == 0) {
      const double x = normal(random), y = normal(random), z = normal(random);
      const auto v = normalized(x, y, z);
      add(v[0], v[1], v[2]);
    } else {
      const double angle = std::pow(10.0, -1 - 6 * uniform(random)), phi = 2 * pi * uniform(random);
      add(std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle) * (i % 4 == 1 ? 1 : -1));
    }
  }
  for (const double sign : {1.0, -1.0}) {
    add(sign, 0, 0);
    add(0, sign, 0);
    add(0, 0, sign);
  }
  return directions;
}

/// The unit of every bound: the greatest |Y_l^0|, which no |Y_l^m| exceeds by more than a little.
inline double largest_of_degree(int l) { return std::sqrt((2 * l + 1) / (4 * 3.14159265358979323846)); }

/// P_0(x) .. P_(count-1)(x).
inline std::vector<long double> legendre_polynomials(int count, long double x) {
  std::vector<long double> p{1, x};
  for (int l = 1; l + 1 < count; ++l) {
    const auto i = static_cast<std::size_t>(l);
    p.push_back(((2 * l + 1) * x * p[i] - l * p[i - 1]) / (l + 1));
  }
  p.resize(static_cast<std::size_t>(count));
  return p;
}
