// Kernels of double, one value of each at x in [-1, 1]. The unit that includes this gives them a name of its own.
#pragma once

#include <array>
#include <cmath>

#include <zonal/zonal.hpp>

constexpr int bands = 12;
constexpr int value_count = 6 + bands * bands + bands;

namespace {
template <class T>
std::array<T, value_count> kernels(double x) {  // whose inputs are numbers that double holds
  std::array<T, value_count> values{zonal::exp(T(700 * x)), zonal::exp(T(3 * x)), zonal::asin(T(x)), zonal::acos(T(x))};
  const auto at = zonal::sin_cos(T(1.5 * x));
  values[4] = at.sine, values[5] = at.cosine;
  const std::array<T, 3> direction{T(std::sqrt(1 - x * x)), T(0.6 * x), T(0.8 * x)};
  int next = 6;
  for (const T& value : zonal::evaluate<bands>(direction)) values[std::size_t(next++)] = value;
  for (const T& value : zonal::project<bands>(zonal::SphericalGaussian<T>{T(20 * (1 + x))})) {
    values[std::size_t(next++)] = value;
  }
  return values;
}
}  // namespace
