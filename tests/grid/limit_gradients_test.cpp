// Limited gradients: how far Hermite interpolation may leave the range of the vertices, and what that costs.
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/grid/limit_gradients.hpp>
#include <zonal/light/sphere.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../catch.hpp"

namespace {

constexpr int N = 2;
using Grid = zonal::CoefficientGrid<N>;
using zonal::Interpolation;

const auto serially = [](int count, const auto& body) {
  for (int i = 0; i < count; ++i) body(i);
};

struct Random {
  std::mt19937 engine;
  float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); }
  glm::vec3 point(float low, float high) {
    const float x = (*this)(low, high), y = (*this)(low, high);
    return {x, y, (*this)(low, high)};
  }
};

/// How far a value is out of a range.
float beyond(float value, float low, float high) { return std::max({low - value, value - high, 0.0F}); }

/// Numbers without any order, gradients steep; degree 0 is 1.
Grid rough_grid(Random& random) {
  Grid grid({-1, 2, 0}, {3, 3, 0.5F}, {5, 4, 6});
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::size_t in_vertex = i % Grid::vertex_size;
    const bool is_value = in_vertex < Grid::block_size;
    grid.data()[i] = is_value ? in_vertex < 3 ? 1.0F : random(-1, 1) : random(-100, 100);
  }
  return grid;
}

}  // namespace

TEST_CASE("limited gradients: along edges and inside cells Hermite's values stay in range, but for what is allowed") {
  Random random{std::mt19937(91)};
  float most_along = 0, most_inside = 0;
  for (const float overshoot : {0.0F, 0.02F, 0.3F}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Grid before = rough_grid(random);
      Grid grid = before;
      zonal::limit_gradients(grid, overshoot);
      for (int place = 0; place < 300; ++place) {
        glm::ivec3 cell;
        glm::vec3 t = random.point(0, 1);
        for (int a = 0; a < 3; ++a) cell[a] = int(random(0, 0.999F) * float(grid.resolution()[a] - 1));
        const int axis = place % 4;  // along an edge, or 3: inside
        for (int a = 0; a < 3; ++a) t[a] = axis == 3 || a == axis ? t[a] : 0;
        const auto got = zonal::interpolate<Interpolation::hermite>(grid, grid.position(cell) + t * grid.spacing());
        for (int i = 0; i < N * N; ++i) {
          for (int c = 0; c < 3; ++c) {
            float low = 2, high = -2;
            for (int corner = 0; corner < 8; ++corner) {
              const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
              bool is_end = true;
              for (int a = 0; a < 3; ++a) is_end = is_end && (axis == 3 || a == axis || step[a] == 0);
              if (!is_end) continue;
              const float value = before.value(cell + step)[i][c];
              low = std::min(low, value), high = std::max(high, value);
            }
            const float out = beyond(got[i][c], low, high);
            CAPTURE(overshoot, trial, cell.x, cell.y, cell.z, t.x, t.y, t.z, i, c, got[i][c], low, high);
            REQUIRE(out <= (axis == 3 ? 3 * overshoot + 0.074F * (high - low) : overshoot) + 1e-5F);
            (axis == 3 ? most_inside : most_along) = std::max(axis == 3 ? most_inside : most_along, out);
          }
        }
      }
      for (std::size_t i = 0; i < grid.size(); ++i) {
        if (i % Grid::vertex_size < Grid::block_size) REQUIRE(grid.data()[i] == before.data()[i]);
      }
    }
  }
  CHECK(most_along > 0.2F);  // the bound is one that is met
  CHECK(most_inside > 0.3F);
}

TEST_CASE(
    "limited gradients: fine cells keep theirs, and the error of coarse ones is between trilinear's and Hermite's") {
  using Light = zonal::ColouredLight<zonal::SphereLight<float>>;
  const std::vector<Light> lights{{{{2, 0.3F, 0}, 0.3F}, glm::vec3(1)},
                                  {{{-0.4F, 1.6F, 0.2F}, 0.1F}, glm::vec3(8)},
                                  {{{0.1F, -0.2F, -2}, 0.6F}, glm::vec3(0.5F)}};
  for (const int vertices : {5, 40}) {
    Grid grid({-1, -1, -1}, {1, 1, 1}, glm::ivec3(vertices));
    zonal::add_lights(grid, lights, serially);
    Grid limited = grid;
    zonal::limit_gradients(limited, 0.03F);
    if (vertices > 5) {
      CHECK(std::equal(grid.data(), grid.data() + grid.size(), limited.data()));
      continue;
    }
    Random random{std::mt19937(92)};
    double error[3] = {};
    for (int i = 0; i < 500; ++i) {
      const glm::vec3 x = random.point(-1, 1);
      zonal::Sh<N, glm::vec3> exact{};
      for (const Light& light : lights) exact += zonal::project<N>(light.light, x) * light.colour;
      const zonal::Sh<N, glm::vec3> got[3] = {zonal::interpolate<Interpolation::hermite>(grid, x),
                                              zonal::interpolate<Interpolation::hermite>(limited, x),
                                              zonal::interpolate<Interpolation::trilinear>(grid, x)};
      for (int k = 0; k < 3; ++k) {
        for (int n = 0; n < N * N; ++n) error[k] += std::pow(double(got[k][n].x - exact[n].x), 2);
      }
    }
    CAPTURE(error[0], error[1], error[2]);
    CHECK(error[0] < error[1]);
    CHECK(error[1] < 0.5 * error[2]);
  }
}
