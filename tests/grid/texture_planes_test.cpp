// A grid's texture planes: every number where the header says, and halves as the compiler's own type rounds them.
#include <zonal/grid/texture_planes.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "../catch.hpp"

namespace {

constexpr int N = 3;
using zonal::GridContent;

template <GridContent content>
zonal::CoefficientGrid<N, content> random_grid() {
  zonal::CoefficientGrid<N, content> grid({-1, -1, -1}, {1, 1, 1}, {3, 2, 4});
  std::mt19937 random(91);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::generate_n(grid.data(), grid.size(), [&] { return uniform(random); });
  return grid;
}

/// By its definition: the nearest of all halves, of two the one whose last bit is 0.
double half_value(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return bits >> 15 ? -size : size;
}

}  // namespace

TEST_CASE("texture planes: with gradients a texel is a number's value and slopes") {
  const auto grid = random_grid<GridContent::values_and_gradients>();
  REQUIRE(zonal::texture_plane_count(grid) == 3 * N * N);
  const std::vector<float> texels = zonal::texture_planes<float>(grid);
  REQUIRE(texels.size() == grid.size());
  for (int vertex = 0; vertex < 24; ++vertex) {
    const auto sh = grid.value_with_gradient({vertex % 3, vertex / 3 % 2, vertex / 6});
    for (int plane = 0; plane < 3 * N * N; ++plane) {
      const float* texel = texels.data() + 4 * (plane * 24 + vertex);
      CAPTURE(vertex, plane);
      CHECK(texel[0] == sh.value[plane / 3][plane % 3]);
      for (int a = 0; a < 3; ++a) CHECK(texel[1 + a] == sh.gradient[a][plane / 3][plane % 3]);
    }
  }
}

TEST_CASE("texture planes: without gradients a texel is four numbers, and what is left over is 0") {
  const auto grid = random_grid<GridContent::values>();
  REQUIRE(zonal::texture_plane_count(grid) == 7);
  const std::vector<float> texels = zonal::texture_planes<float>(grid);
  REQUIRE(texels.size() == 4 * 7 * 24);
  for (int vertex = 0; vertex < 24; ++vertex) {
    const auto sh = grid.value({vertex % 3, vertex / 3 % 2, vertex / 6});
    for (int number = 0; number < 28; ++number) {
      const float texel = texels[static_cast<std::size_t>(4 * (number / 4 * 24 + vertex) + number % 4)];
      CAPTURE(vertex, number);
      CHECK(texel == (number < 27 ? sh[number / 3][number % 3] : 0.0F));
    }
  }
}

TEST_CASE("texture planes: 16 bits are the nearest halves, bounded") {
  zonal::CoefficientGrid<1, GridContent::values> grid({0, 0, 0}, {1, 1, 1}, {32, 32, 32});
  std::mt19937 random(92);
  std::uniform_real_distribution<float> exponent(-27, 18), fraction(-1, 1);
  std::generate_n(grid.data(), grid.size(),
                  [&] { return std::ldexp(fraction(random), static_cast<int>(exponent(random))); });
  const float extremes[] = {0.0F,
                            -0.0F,
                            65504.0F,
                            65519.9F,
                            65520.0F,
                            1e30F,
                            -1e30F,
                            1.0F + 0x1p-11F,
                            1.0F + 0x3p-11F,
                            0x1p-25F,
                            0x1.8p-24F,
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
  std::copy(std::begin(extremes), std::end(extremes), grid.data());
  grid.data()[20] = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::uint16_t> halves = zonal::texture_planes<std::uint16_t>(grid);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::uint16_t half = halves[4 * (i / 3) + i % 3];
    const float x = grid.data()[i];
    CAPTURE(i, x, half);
    if (std::isnan(x)) {
      REQUIRE((half & 0x7C00) == 0x7C00);
      REQUIRE((half & 0x3FF) != 0);
      continue;
    }
    REQUIRE((half & 0x7C00) != 0x7C00);
    const double wanted = std::clamp(static_cast<double>(x), -65504.0, 65504.0);
    const double error = std::abs(half_value(half) - wanted);
    REQUIRE(std::signbit(half_value(half)) == std::signbit(x));
    for (const int neighbour : {half - 1, half + 1}) {
      if ((neighbour & 0x7FFF) == 0x7FFF || (neighbour & 0x7C00) == 0x7C00 || neighbour < 0) continue;
      const double other = std::abs(half_value(static_cast<std::uint16_t>(neighbour)) - wanted);
      REQUIRE((error < other || (error <= other && half % 2 == 0)));
    }
  }
}
