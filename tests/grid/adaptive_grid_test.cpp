// Grids of cells of different sizes, against the fine grid that they are made from.
#include <zonal/grid/adaptive_grid.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

constexpr int N = 3;
using Fine = zonal::CoefficientGrid<N, zonal::GridContent::values>;
using zonal::AdaptiveGrid;

template <class Function>
Fine grid_of(const glm::ivec3& resolution, const Function& function) {
  Fine grid({-1, 0, 2}, {1, 3, 2.5F}, resolution);
  for (int k = 0; k < resolution.z; ++k) {
    for (int j = 0; j < resolution.y; ++j) {
      for (int i = 0; i < resolution.x; ++i) {
        zonal::Sh<N, glm::vec3> value{};
        for (int n = 0; n < N * N; ++n) value[n] = function(grid.position({i, j, k})) * float(n + 1);
        grid.set({i, j, k}, value);
      }
    }
  }
  return grid;
}

/// Bright on one side of a slanted plane: what changes, changes there.
glm::vec3 edge(const glm::vec3& p) {
  const float side = p.x + 0.3F * p.y + p.z - 2.5F;
  return glm::vec3(side > 0 ? 1.0F : 0.0F, 1 / (1 + side * side), 2);
}

/// Bright about one place.
glm::vec3 lamp(const glm::vec3& p) {
  const glm::vec3 d = p - glm::vec3(0.3F, 0.8F, 2.4F);
  return glm::vec3(1, 0.5F, 0.1F) / (0.02F + glm::dot(d, d));
}

glm::vec3 random_place(std::mt19937& random, float beyond) {
  std::uniform_real_distribution<float> uniform(-beyond, 1 + beyond);
  return {-1 + 2 * uniform(random), 3 * uniform(random), 2 + 0.5F * uniform(random)};
}

template <class Get>
double squared_error(const Get& get, const Fine& truth) {
  std::mt19937 random(5);
  double sum = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 place = random_place(random, 0);
    const auto value = get(place), exact = zonal::interpolate<zonal::Interpolation::trilinear>(truth, place);
    for (int n = 0; n < N * N; ++n) sum += double(glm::dot(value[n] - exact[n], value[n] - exact[n]));
  }
  return sum;
}

}  // namespace

TEST_CASE("adaptive grid: with all vertices it is the fine grid, in the box and beyond") {
  Met met("grid", "AdaptiveGrid");
  const Fine fine = grid_of({17, 9, 25}, edge);
  const AdaptiveGrid<N> all(fine, 3, fine.vertex_count() + 19);
  CHECK(all.vertex_count() == fine.vertex_count());
  CHECK(all.cell_count() == 16 * 8 * 24);
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 place = random_place(random, 0.2F);
    const auto value = all.interpolate(place),
               expected = zonal::interpolate<zonal::Interpolation::trilinear>(fine, place);
    for (int n = 0; n < N * N; ++n) {
      INFO(place.x << ' ' << place.y << ' ' << place.z << ", " << n);
      REQUIRE(met.meet(double(glm::length(value[n] - expected[n])) / (n + 1)));
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("adaptive grid: at equal memory it errs less than a grid of equal cells") {
  const Fine fine = grid_of({33, 33, 33}, lamp), even = grid_of({9, 9, 9}, lamp);
  const AdaptiveGrid<N> grid(fine, 5, even.vertex_count());
  CHECK(grid.vertex_count() <= even.vertex_count());
  CHECK(grid.bytes() <= even.size() * sizeof(float) * 5 / 4);  // cells are 36 bytes, vertices 108
  const double adaptive = squared_error([&](const auto& place) { return grid.interpolate(place); }, fine);
  const double plain = squared_error(
      [&](const auto& place) { return zonal::interpolate<zonal::Interpolation::trilinear>(even, place); }, fine);
  INFO(adaptive << " against " << plain);
  CHECK(adaptive < 0.3 * plain);  // of squares
  // More vertices, less error.
  double before = std::numeric_limits<double>::infinity();
  for (const std::size_t vertices :
       {std::size_t{100}, std::size_t{1000}, std::size_t{10000}, fine.vertex_count() + 19}) {
    const AdaptiveGrid<N> some(fine, 5, vertices);
    const double error = squared_error([&](const auto& place) { return some.interpolate(place); }, fine);
    CHECK(error < before);
    before = error;
  }
}

TEST_CASE("adaptive grid: the field is continuous, and a linear one exact with eight vertices") {
  const Fine fine = grid_of({33, 17, 17}, edge);
  const AdaptiveGrid<N> grid(fine, 4, 2000);
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    // On a face of some fine cell, and just beside it.
    glm::vec3 place = random_place(random, 0);
    const int axis = int(random() % 3);
    place[axis] = fine.position(glm::ivec3(int(random() % 15) + 1))[axis];
    glm::vec3 beside = place;
    beside[axis] = std::nextafter(beside[axis], -10.0F);
    const auto a = grid.interpolate(place), b = grid.interpolate(beside);
    INFO(place.x << ' ' << place.y << ' ' << place.z << ", across axis " << axis);
    for (int n = 0; n < N * N; ++n) REQUIRE(glm::length(a[n] - b[n]) <= 1e-4F * float(n + 1));
  }

  const auto plane = [](const glm::vec3& p) { return glm::vec3(p.x, p.y - p.z, 1); };
  const AdaptiveGrid<N> linear(grid_of({17, 17, 17}, plane), 4, 0);
  CHECK(linear.vertex_count() == 8);
  for (int i = 0; i < 100; ++i) {
    const glm::vec3 place = random_place(random, 0);
    REQUIRE(glm::length(linear.interpolate(place)[2] - 3.0F * plane(place)) <= 1e-5F);
  }
}

TEST_CASE("adaptive grid: cells that cannot be joined are refused; no number as a position gives none") {
  const Fine fine = grid_of({9, 9, 7}, edge);
  REQUIRE_THROWS_AS(AdaptiveGrid<N>(fine, 2, 100), std::invalid_argument);
  REQUIRE_THROWS_AS(AdaptiveGrid<N>(fine, -1, 100), std::invalid_argument);
  REQUIRE_THROWS_AS(AdaptiveGrid<N>(fine, 40, 100), std::invalid_argument);
  const AdaptiveGrid<N> grid(fine, 1, 200);
  REQUIRE(std::isnan(grid.interpolate(glm::vec3(0, std::numeric_limits<float>::quiet_NaN(), 2))[0].x));
}
