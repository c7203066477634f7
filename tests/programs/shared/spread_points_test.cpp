// The points by the definition of a (t, s)-sequence, box by box, and by integrals of all coordinates at once.
#include "shared/spread_points.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "catch.hpp"

namespace {

using namespace example;

/// A box's side on each axis is a whole part of 2^-bits; calls visit(bits) for all whose bits sum up to `sum`.
template <class Visit>
void for_each_shape(int axes, int sum, std::vector<int>& bits, const Visit& visit) {
  if (axes == 1) {
    bits.push_back(sum);
    visit(bits);
    bits.pop_back();
    return;
  }
  for (int first = 0; first <= sum; ++first) {
    bits.push_back(first);
    for_each_shape(axes - 1, sum - first, bits, visit);
    bits.pop_back();
  }
}

/// How many of the 2^m points from the first on are in the fullest of the boxes of this shape.
int most_in_a_box(const SpreadPoints& points, std::uint32_t first, int m, const std::vector<int>& bits) {
  std::vector<int> counts(std::size_t(1) << unsigned(m));
  int most = 0;
  for (std::uint32_t i = 0; i < (1u << unsigned(m)); ++i) {
    const glm::vec4 point = points.point(first + i);
    std::size_t box = 0;
    for (std::size_t axis = 0; axis < bits.size(); ++axis) {
      const float parts = std::ldexp(1.0f, bits[axis]);
      box = (box << unsigned(bits[axis])) + static_cast<std::size_t>(point[int(axis)] * parts);
    }
    most = std::max(most, ++counts[box]);
  }
  return most;
}

/// The mean over seeds of the squared error of n points' mean of a product of sines of all coordinates, whose mean
/// is 1.
template <class Point>
double mean_squared_error(int n, const Point& point_of) {
  double sum = 0.0;
  constexpr int seeds = 32;
  for (int seed = 0; seed < seeds; ++seed) {
    double mean = 0.0;
    Pcg32 random(static_cast<std::uint64_t>(seed));
    const SpreadPoints points(random);
    for (int i = 0; i < n; ++i) {
      const glm::vec4 u = point_of(points, random, static_cast<std::uint32_t>(i));
      double product = 1.0;
      for (int axis = 0; axis < 4; ++axis) {
        constexpr double pi = 3.14159265358979323846;
        product *= pi / 2.0 * std::sin(pi * static_cast<double>(u[axis]));
      }
      mean += product / n;
    }
    sum += (mean - 1.0) * (mean - 1.0) / seeds;
  }
  return sum;
}

}  // namespace

TEST_CASE("each run of a power of two points fills all boxes alike, in two, three and four dimensions") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Pcg32 random(seed);
    const SpreadPoints points(random);
    for (int dimensions = 1; dimensions <= 4; ++dimensions) {
      const int t = dimensions < 3 ? 0 : dimensions == 3 ? 1 : 3;
      for (int m = t; m <= 9; ++m) {
        for (const std::uint32_t run : {0u, 1u, 2u, 5u, 1000u}) {
          std::vector<int> shape;
          for_each_shape(dimensions, m - t, shape, [&](const std::vector<int>& bits) {
            CAPTURE(seed, dimensions, m, run, bits[0], bits.back());
            // No box holds more than its share: so none holds less.
            REQUIRE(most_in_a_box(points, run << unsigned(m), m, bits) == 1 << t);
          });
        }
      }
    }
  }
}

TEST_CASE("an integral over all four coordinates converges faster than by random points") {
  const auto spread = [](const SpreadPoints& points, Pcg32&, std::uint32_t i) { return points.point(i); };
  const auto random = [](const SpreadPoints&, Pcg32& numbers, std::uint32_t) {
    const glm::vec2 first = numbers.uniform2();
    return glm::vec4(first, numbers.uniform2());
  };
  // What points whose last coordinates follow from the first ones never reach.
  const double at_16 = mean_squared_error(16, spread), at_4096 = mean_squared_error(4096, spread);
  CAPTURE(at_16, at_4096, mean_squared_error(4096, random));
  CHECK(at_16 < mean_squared_error(16, random));
  CHECK(at_4096 < 0.01 * mean_squared_error(4096, random));
}

TEST_CASE("each point is anywhere, by its seed") {
  constexpr int cells = 16, seeds = 16384;
  for (const std::uint32_t index : {0u, 1u, 77u}) {
    int counts[4][cells] = {};
    for (int seed = 0; seed < seeds; ++seed) {
      Pcg32 random(static_cast<std::uint64_t>(seed));
      const glm::vec4 point = SpreadPoints(random).point(index);
      for (int axis = 0; axis < 4; ++axis) ++counts[axis][static_cast<int>(point[axis] * cells)];
    }
    for (int axis = 0; axis < 4; ++axis) {
      for (int cell = 0; cell < cells; ++cell) {
        CAPTURE(index, axis, cell);
        const double expected = seeds / cells;
        CHECK(std::abs(counts[axis][cell] - expected) < 5.0 * std::sqrt(expected));
      }
    }
  }
}
