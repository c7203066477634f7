// A grid filled in packets, four lights at a time, against each light at each vertex by itself, in double. (The
// gradient as far as a cell takes it: beside_light_test.cpp.)
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/light/point.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

constexpr int N = 6;

const auto serially = [](int count, const auto& body) {
  for (int i = 0; i < count; ++i) body(i);
};

template <class T>
glm::vec<3, T> random_point(std::mt19937& random, T low, T high) {
  std::uniform_real_distribution<T> uniform(low, high);
  const T x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

template <int V>
auto limited(const zonal::PolygonLight<V, double>& light, const glm::dvec3& x, double) {
  return zonal::project_with_gradient<N>(light, x);
}
auto limited(const zonal::DirectionalLight<double>& light, const glm::dvec3& x, double) {
  return zonal::project_with_gradient<N>(light, x);
}
template <class Light>
auto limited(const Light& light, const glm::dvec3& x, double cell) {
  return zonal::project_with_limited_gradient<N>(light, x, cell);
}

template <class Light, class Widen, class Add>
void check(const std::vector<zonal::ColouredLight<Light>>& lights, const glm::ivec3& resolution, Widen widen, Met& met,
           Add add) {
  zonal::CoefficientGrid<N> grid({-1, -1, -1}, {1, 2, 0.5F}, resolution);
  add(grid);
  const double cell = static_cast<double>(std::max({grid.spacing().x, grid.spacing().y, grid.spacing().z}));
  for (int k = 0; k < resolution.z; ++k) {
    for (int j = 0; j < resolution.y; ++j) {
      for (int i = 0; i < resolution.x; ++i) {
        const glm::ivec3 vertex(i, j, k);
        const auto got = grid.value_with_gradient(vertex);
        for (int c = 0; c < 3; ++c) {
          zonal::ShGradient<N, double> expected{};
          for (const auto& light : lights) {
            const auto one = limited(widen(light.light), glm::dvec3(grid.position(vertex)), cell);
            const auto colour = static_cast<double>(light.colour[c]);
            expected.value += one.value * colour;
            for (int a = 0; a < 3; ++a) expected.gradient[a] += one.gradient[a] * colour;
          }
          double unit = 1e-30, slope = 1e-30;
          for (int n = 0; n < N * N; ++n) {
            unit = std::max(unit, std::abs(expected.value[n]));
            for (const auto& gradient : expected.gradient) slope = std::max(slope, std::abs(gradient[n]));
          }
          for (int n = 0; n < N * N; ++n) {
            CAPTURE(lights.size(), i, j, k, c, n);
            REQUIRE(met.meet(std::abs(static_cast<double>(got.value[n][c]) - expected.value[n]) / unit));
            for (int a = 0; a < 3; ++a) {
              REQUIRE(met.meet(std::abs(static_cast<double>(got.gradient[a][n][c]) - expected.gradient[a][n]) / slope));
            }
          }
        }
      }
    }
  }
}

template <class Light, class Widen>
void check(const std::vector<zonal::ColouredLight<Light>>& lights, const glm::ivec3& resolution, Widen widen,
           Met& met) {
  check(lights, resolution, widen, met, [&](auto& grid) { zonal::add_lights(grid, lights, serially); });
}

template <class MakeLight>
auto random_lights(std::size_t count, unsigned seed, MakeLight make) {
  std::mt19937 random(seed);
  std::vector<zonal::ColouredLight<decltype(make(random))>> lights;
  for (std::size_t i = 0; i < count; ++i) {
    const auto light = make(random);
    lights.push_back({light, random_point(random, 0.0F, 2.0F)});
  }
  return lights;
}

}  // namespace

TEST_CASE("grid from sphere lights: any number of lights, any resolution") {
  Met met("grid", "add_lights");
  const auto sphere = [](std::mt19937& random) {
    return zonal::SphereLight<float>{random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2), 0.2F};
  };
  const auto widen = [](const zonal::SphereLight<float>& light) {
    return zonal::SphereLight<double>{glm::dvec3(light.center), static_cast<double>(light.radius)};
  };
  for (const std::size_t count : {0U, 1U, 3U, 4U, 5U, 17U}) {
    check(random_lights(count, 61, sphere), {2, 3, 4}, widen, met);
  }
  check(random_lights(7, 62, sphere), {5, 2, 7}, widen, met);
  CHECK_MET(met);
}

TEST_CASE("grid from other lights: points, spots, triangles as spheres") {
  Met met("grid", "add_lights");
  check(
      random_lights(5, 63,
                    [](std::mt19937& random) {
                      return zonal::PointLight<float>{random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2)};
                    }),
      {3, 3, 3},
      [](const zonal::PointLight<float>& light) { return zonal::PointLight<double>{glm::dvec3(light.center)}; }, met);
  check(
      random_lights(5, 64,
                    [](std::mt19937& random) {
                      const glm::vec3 corner = random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2);
                      return zonal::TriangleSphereLight<float>::approximate(
                          {{corner, corner + glm::vec3(0.2F, 0, 0.05F), corner + glm::vec3(0, 0.3F, 0)}});
                    }),
      {3, 3, 3},
      [](const zonal::TriangleSphereLight<float>& light) {
        return zonal::TriangleSphereLight<double>{glm::dvec3(light.center), glm::dvec3(light.normal),
                                                  static_cast<double>(light.radius)};
      },
      met);
  CHECK_MET(met);
}

TEST_CASE("grid from other lights: spots, soft spheres") {
  Met met("grid", "add_lights");
  check(
      random_lights(6, 65,
                    [](std::mt19937& random) {
                      return zonal::SpotLight<float>{
                          random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2), {0, 0.6F, -0.8F}, 0.95F, 0.2F};
                    }),
      {3, 3, 3},
      [](const zonal::SpotLight<float>& light) {
        return zonal::SpotLight<double>{glm::dvec3(light.center), glm::dvec3(light.axis),
                                        static_cast<double>(light.cos_inner), static_cast<double>(light.cos_outer)};
      },
      met);
  check(
      random_lights(
          6, 66,
          [](std::mt19937& random) {
            zonal::SoftSphereLight<N, float> light{random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2), 0.3F, {}};
            for (int l = 0; l < N; ++l) light.kernel[l] = 1.0F / static_cast<float>(1 + l);
            return light;
          }),
      {3, 3, 3},
      [](const zonal::SoftSphereLight<N, float>& light) {
        zonal::SoftSphereLight<N, double> wide{glm::dvec3(light.center), static_cast<double>(light.radius), {}};
        for (int l = 0; l < N; ++l) wide.kernel[l] = static_cast<double>(light.kernel[l]);
        return wide;
      },
      met);
  CHECK_MET(met);
}

TEST_CASE("grid from directional lights: the same everywhere") {
  Met met("grid", "add_lights");
  check(
      random_lights(3, 68,
                    [](std::mt19937& random) {
                      return zonal::DirectionalLight<float>{glm::normalize(random_point(random, -1.0F, 1.0F))};
                    }),
      {3, 2, 2},
      [](const zonal::DirectionalLight<float>& light) {
        return zonal::DirectionalLight<double>{glm::dvec3(light.direction)};
      },
      met);
  CHECK_MET(met);
}

namespace {

template <int V>
zonal::PolygonLight<V, double> widened(const zonal::PolygonLight<V, float>& light) {
  zonal::PolygonLight<V, double> wide;
  for (int v = 0; v < V; ++v) wide.vertices[v] = glm::dvec3(light.vertices[v]);
  return wide;
}

/// A square light at z = 2, cut into side * side * 2 triangles; every other one runs the other way around.
template <class Colour>
std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> cut_square(int side, const Colour& colour) {
  std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> lights;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const auto corner = [&](int a, int b) {
        return glm::vec3(-0.9F + static_cast<float>(i + a) / static_cast<float>(side),
                         -0.3F + static_cast<float>(j + b) / static_cast<float>(side), 2);
      };
      lights.push_back({{{corner(0, 0), corner(1, 0), corner(0, 1)}}, colour(lights.size())});
      lights.push_back({{{corner(1, 0), corner(0, 1), corner(1, 1)}}, colour(lights.size())});
    }
  }
  return lights;
}

}  // namespace

TEST_CASE("grid from polygons: each by itself, and as neighbours that share their edges") {
  Met met("grid", "add_lights, polygons");
  const auto widen = [](const auto& light) { return widened(light); };
  const auto adding = [](const auto& lights) {
    return [&](auto& grid) { zonal::add_lights(grid, lights, 1e-7, serially); };
  };
  for (const std::size_t count : {0U, 1U, 2U, 5U}) {
    const auto lights = random_lights(count, 67, [](std::mt19937& random) {
      const glm::vec3 corner = random_point(random, -0.5F, 0.5F) + glm::vec3(0, 0, 2);
      return zonal::PolygonLight<4, float>{{corner, corner + glm::vec3(0.4F, 0, 0.2F),
                                            corner + glm::vec3(0.4F, 0.3F, 0.2F), corner + glm::vec3(0, 0.3F, 0)}};
    });
    check(lights, {4, 6, 4}, widen, met, adding(lights));  // far enough: no gradient is limited
  }
  const auto gaudy = cut_square(3, [](std::size_t i) {
    return glm::vec3(static_cast<float>(i % 5) * 0.25F, static_cast<float>(i % 3), i % 7 == 0 ? 4.0F : 0.5F);
  });
  check(gaudy, {4, 6, 4}, widen, met, adding(gaudy));
  CHECK_MET(met);
}

TEST_CASE("grid from polygons: a uniform light is its outline, however finely it is cut") {
  const auto one = [](std::size_t) { return glm::vec3(1, 2, 3); };
  zonal::CoefficientGrid<N> whole({-1, -1, -1}, {1, 2, 0.5F}, {3, 3, 3}), cut = whole;
  zonal::add_lights(whole, cut_square(1, one), 1e-7, serially);
  zonal::add_lights(cut, cut_square(16, one), 1e-7, serially);
  float largest = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) largest = std::max(largest, std::abs(whole.data()[i]));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CAPTURE(i);
    REQUIRE(std::abs(whole.data()[i] - cut.data()[i]) <= 2e-6F * largest);
  }
}

TEST_CASE("grid from polygons: begun at a straight corner, not convex, or without an area") {
  using Quad = zonal::PolygonLight<4, float>;
  const auto grid_of = [](const auto& lights) {
    zonal::CoefficientGrid<N> grid({-1, -1, 0.5F}, {1, 1, 2}, {7, 7, 6});
    zonal::add_lights(grid, lights, serially);
    return grid;
  };
  const auto check_same = [](const auto& a, const auto& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a.data()[i]));
    REQUIRE(largest > 0.1F);
    for (std::size_t i = 0; i < a.size(); ++i) {
      CAPTURE(i);
      REQUIRE(std::abs(a.data()[i] - b.data()[i]) <= 4e-6F * largest);
    }
  };
  const glm::vec3 colour(1, 2, 0.5F);
  const std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> triangle{
      {{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}, colour}};
  const auto expected = grid_of(triangle);
  const glm::vec3 corners[] = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  for (int start = 0; start < 4; ++start) {
    Quad quad;
    for (int i = 0; i < 4; ++i) quad.vertices[i] = corners[(start + i) % 4];
    CAPTURE(start);
    check_same(expected, grid_of(std::vector<zonal::ColouredLight<Quad>>{{quad, colour}}));
  }

  // An arrow begun at its notch, and as two triangles.
  const std::vector<zonal::ColouredLight<Quad>> arrow{{{{{-0.5F, 0, 0}, {-1, -1, 0}, {1, 0, 0}, {-1, 1, 0}}}, colour}};
  const std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> parts{
      {{{{-0.5F, 0, 0}, {-1, -1, 0}, {1, 0, 0}}}, colour}, {{{{-0.5F, 0, 0}, {1, 0, 0}, {-1, 1, 0}}}, colour}};
  check_same(grid_of(parts), grid_of(arrow));

  // What has no area adds nothing, wherever it is: at a vertex of the grid, too.
  auto with_nothing = triangle;
  with_nothing.push_back({{{{0, 0, 0.5F}, {0, 0, 0.5F}, {1, 0, 2}}}, colour});
  with_nothing.push_back({{{{0, 0, 0.5F}, {0, 0, 0.5F}, {0, 0, 0.5F}}}, colour});
  check_same(expected, grid_of(with_nothing));
  std::vector<zonal::ColouredLight<zonal::TriangleSphereLight<float>>> spheres;
  for (const auto& light : with_nothing) {
    spheres.push_back({zonal::TriangleSphereLight<float>::approximate(light.light), light.colour});
  }
  zonal::CoefficientGrid<N> with({-1, -1, 0.5F}, {1, 1, 2}, {3, 3, 3}), without = with;
  zonal::add_lights(with, spheres, serially);
  spheres.resize(1);
  zonal::add_lights(without, spheres, serially);
  for (std::size_t i = 0; i < with.size(); ++i) REQUIRE(with.data()[i] == without.data()[i]);
}

TEST_CASE("grid from polygons: the tolerance is held against the sum of all lights") {
  std::mt19937 random(69);
  std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> lights;
  for (int i = 0; i < 12; ++i) {
    const glm::vec3 corner = random_point(random, -1.0F, 1.0F) + glm::vec3(0, 0, 1.6F);
    lights.push_back(
        {{{corner, corner + random_point(random, -0.7F, 0.7F), corner + random_point(random, -0.7F, 0.7F)}},
         random_point(random, 0.0F, 2.0F)});
  }
  const glm::ivec3 resolution(3, 3, 3);
  zonal::CoefficientGrid<N> exact({-1, -1, -1}, {1, 1, 1}, resolution);
  zonal::add_lights(exact, lights, 1e-7, serially);
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    zonal::CoefficientGrid<N> grid({-1, -1, -1}, {1, 1, 1}, resolution);
    zonal::add_lights(grid, lights, tolerance, serially);
    for (int vertex = 0; vertex < 27; ++vertex) {
      const glm::ivec3 at(vertex % 3, vertex / 3 % 3, vertex / 9);
      const auto got = grid.value(at), expected = exact.value(at);
      for (int i = 0; i < N * N; ++i) {
        for (int c = 0; c < 3; ++c) {
          CAPTURE(tolerance, vertex, i, c);
          REQUIRE(std::abs(got[i][c] - expected[i][c]) <= (static_cast<float>(tolerance) + 2e-5F) * expected[0][c]);
        }
      }
    }
  }
}

TEST_CASE("grid: lights add up, and a grid is no larger than its data") {
  zonal::CoefficientGrid<N> grid({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  const std::vector<zonal::ColouredLight<zonal::SphereLight<float>>> lights{{{{0, 0, 3}, 0.5F}, {1, 2, 3}}};
  zonal::add_lights(grid, lights, serially);
  const auto once = grid.value({1, 0, 1});
  zonal::add_lights(grid, lights, serially);
  for (int i = 0; i < N * N; ++i) CHECK(grid.value({1, 0, 1})[i] == once[i] * 2.0F);
  CHECK(grid.size() == 8 * 4 * 3 * N * N);
}
