// The frame about a unit vector: orthonormal, right-handed, about its own axis, wherever that points.
#include <zonal/scalar/vector3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "../catch.hpp"

namespace {

template <class T>
struct Unit {
  T at[3];
};

/// Unit vectors: random ones, those about the axes and about the plane z = 0, at every distance down to rounding.
template <class T>
std::vector<Unit<T>> axes() {
  std::vector<Unit<T>> all;
  const auto add = [&](long double x, long double y, long double z) {
    const long double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0) all.push_back({{T(x / length), T(y / length), T(z / length)}});
  };
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10000; ++i) add(normal(random), normal(random), normal(random));
  for (int axis = 0; axis < 3; ++axis) {
    for (const long double side : {-1.0L, 1.0L}) {
      for (int power = 0; power <= 60; ++power) {
        long double v[3] = {std::ldexp(normal(random), -power), std::ldexp(normal(random), -power), 0};
        std::swap(v[2], v[axis]);
        v[axis] = side;
        add(v[0], v[1], v[2]);
        v[(axis + 1) % 3] = 0;
        add(v[0], v[1], v[2]);
      }
    }
  }
  for (const long double zero : {0.0L, -0.0L}) {
    add(1, zero, zero), add(-1, zero, zero), add(zero, 1, zero), add(zero, -1, zero);
    add(zero, zero, 1), add(zero, zero, -1), add(1, 1, zero);
  }
  return all;
}

/// The greatest difference from a right-handed orthonormal frame.
template <class T>
long double error_of(const Unit<T>& axis) {
  T x[3], y[3];
  zonal::complete_frame(axis.at, x, y);
  const T* frame[3] = {x, y, axis.at};
  long double worst = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      long double product = 0;
      for (int k = 0; k < 3; ++k) product += static_cast<long double>(frame[i][k]) * frame[j][k];
      if (i != 2 || j != 2) worst = std::max(worst, std::abs(product - (i == j ? 1 : 0)));
    }
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const long double cross = static_cast<long double>(x[a]) * y[b] - static_cast<long double>(x[b]) * y[a];
    worst = std::max(worst, std::abs(cross - axis.at[i]));
  }
  return worst;
}

template <class T>
void check_frames() {
  long double worst = 0;
  Unit<T> at{};
  for (const Unit<T>& axis : axes<T>()) {
    const long double error = error_of(axis);
    if (!(error <= worst)) worst = error, at = axis;
  }
  INFO("worst at " << at.at[0] << ", " << at.at[1] << ", " << at.at[2] << ": " << double(worst));
  CHECK(worst <= 3 * std::numeric_limits<T>::epsilon());
}

}  // namespace

TEST_CASE("A frame about any unit vector is right-handed and orthonormal, in float") { check_frames<float>(); }
TEST_CASE("A frame about any unit vector is right-handed and orthonormal, in double") { check_frames<double>(); }
