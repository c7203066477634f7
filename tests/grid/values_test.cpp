// Grids of values alone: the values of a grid with gradients, to the bit where the same sums make them.
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/light/point.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../catch.hpp"
#include "../files.hpp"

namespace {

constexpr int N = 3;
using zonal::GridContent, zonal::Interpolation;
using Full = zonal::CoefficientGrid<N>;
using Values = zonal::CoefficientGrid<N, GridContent::values>;
template <class Light>
using Lights = std::vector<zonal::ColouredLight<Light>>;

const glm::vec3 low{-1, -2, -0.5F}, high{1, 2, 1};
const glm::ivec3 resolution{3, 5, 3};

const auto serially = [](int count, const auto& body) {
  for (int i = 0; i < count; ++i) body(i);
};

/// Both grids, filled by add(grid).
template <class Add>
void check(const char* name, const Add& add) {
  CAPTURE(name);
  Full full(low, high, resolution);
  Values values(low, high, resolution);
  add(full);
  add(values);
  const Values expected = zonal::values_of(full);
  REQUIRE(values.size() == expected.size());
  REQUIRE(4 * values.size() == full.size());
  bool is_lit = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(i, values.data()[i], expected.data()[i]);
    REQUIRE(std::abs(values.data()[i] - expected.data()[i]) <= 1e-6F * std::abs(expected.data()[i]));
    is_lit = is_lit || values.data()[i] > 0.01F;
  }
  REQUIRE(is_lit);
}

Lights<zonal::SphereLight<float>> spheres() {
  Lights<zonal::SphereLight<float>> lights;
  for (int i = 0; i < 7; ++i) {  // not a multiple of the four that are summed at once; one about a vertex
    const float t = static_cast<float>(i);
    lights.push_back({{{std::cos(t), 2 * std::sin(t), 0.3F * t - 0.5F}, 0.05F + 0.05F * t}, {1, 0.1F * t, 2}});
  }
  lights.push_back({{{0, 0, 0.25F}, 0.2F}, {1, 2, 3}});
  return lights;
}

struct Float3 {
  float x, y, z;
};

}  // namespace

TEST_CASE("grid of values: every kind of light leaves what a grid with gradients has for values") {
  check("spheres", [](auto& grid) { zonal::add_lights(grid, spheres(), serially); });
  check("points, one at a vertex", [](auto& grid) {
    zonal::add_lights(grid, Lights<zonal::PointLight<float>>{{{{0, 0, 0.25F}}, {1, 2, 3}}, {{{3, 2, 1}}, {4, 1, 1}}},
                      serially);
  });
  check("spots, which are modulated", [](auto& grid) {
    const zonal::SpotLight<float> spot{{0.5F, -0.25F, 3}, {0, 0, -1}, 0.97F, 0.25F};
    zonal::add_lights(grid, Lights<zonal::SpotLight<float>>{{spot, {1, 2, 3}}}, serially);
  });
  check("directional lights", [](auto& grid) {
    zonal::add_lights(grid, Lights<zonal::DirectionalLight<float>>{{{{0.6F, 0, 0.8F}}, {1, 2, 3}}}, serially);
  });
  check("triangles", [](auto& grid) {
    const zonal::TriangleLight<float> triangle{{{-1, -1, 2}, {1, -0.5F, 2.5F}, {0.25F, 1, 2}}};
    zonal::add_lights(grid, Lights<zonal::TriangleLight<float>>{{triangle, {1, 2, 3}}}, 1e-5, serially);
  });
}

TEST_CASE("grid of values: it interpolates as the other does trilinearly, for vectors and colours of one's own") {
  Full full(low, high, resolution);
  zonal::add_lights(full, spheres(), serially);
  const Values values = zonal::values_of(full);
  for (int i = 0; i < 50; ++i) {
    const float t = static_cast<float>(i);
    const glm::vec3 p(1.2F * std::sin(7 * t), 2.2F * std::sin(5 * t), 1.1F * std::sin(3 * t));  // outside as well
    const auto expected = zonal::interpolate_with_gradient<Interpolation::trilinear>(full, p);
    const auto got = zonal::interpolate_with_gradient<Interpolation::trilinear>(values, p);
    const auto own = zonal::interpolate<Interpolation::trilinear, Float3>(values, std::array<float, 3>{p.x, p.y, p.z});
    const auto hermite = zonal::interpolate<Interpolation::hermite>(full, p);
    const auto own_hermite =
        zonal::interpolate<Interpolation::hermite, std::array<float, 3>>(full, Float3{p.x, p.y, p.z});
    for (int n = 0; n < N * N; ++n) {
      CAPTURE(i, n);
      REQUIRE(got.value[n] == expected.value[n]);
      for (int a = 0; a < 3; ++a) REQUIRE(got.gradient[a][n] == expected.gradient[a][n]);
      REQUIRE(glm::vec3(own[n].x, own[n].y, own[n].z) == expected.value[n]);
      REQUIRE(glm::vec3(own_hermite[n][0], own_hermite[n][1], own_hermite[n][2]) == hermite[n]);
    }
  }
}

TEST_CASE("grid of values: what is set comes back") {
  Values values(low, high, resolution);
  zonal::Sh<N, glm::vec3> sh;
  for (int i = 0; i < N * N; ++i) sh[i] = glm::vec3(float(i), float(i) + 0.25F, -float(i));
  values.set({2, 4, 1}, sh);
  Full full(low, high, resolution);
  full.set({2, 4, 1}, {sh, {sh, sh, sh}});
  full.set({2, 4, 1}, sh * 2.0F);
  for (int i = 0; i < N * N; ++i) {
    CHECK(values.value({2, 4, 1})[i] == sh[i]);
    CHECK(values.value({1, 4, 1})[i] == glm::vec3(0));
    CHECK(full.value({2, 4, 1})[i] == sh[i] * 2.0F);
    CHECK(full.value_with_gradient({2, 4, 1}).gradient[1][i] == sh[i]);
  }
}

TEST_CASE("grid of values: its file says what it has, and is not taken for the other") {
  const file_test::Folder folder;
  Full full(low, high, resolution);
  zonal::add_lights(full, spheres(), serially);
  const Values values = zonal::values_of(full);
  const auto full_path = folder.path / "full.grid", values_path = folder.path / "values.grid";
  zonal::save_grid(full_path, full);
  zonal::save_grid(values_path, values);
  CHECK(std::filesystem::file_size(values_path) == 60 + 4 * values.size() + 8);
  CHECK(zonal::read_grid_header(full_path).content == GridContent::values_and_gradients);
  CHECK(zonal::read_grid_header(values_path).content == GridContent::values);
  const Values loaded = zonal::load_grid<N, GridContent::values>(values_path);
  CHECK(std::vector<float>(loaded.data(), loaded.data() + loaded.size()) ==
        std::vector<float>(values.data(), values.data() + values.size()));

  const auto error_of = [](const auto& load) -> std::string {
    try {
      load();
    } catch (const zonal::GridFileError& error) {
      return error.what();
    }
    return {};
  };
  CHECK(file_test::contains(error_of([&] { zonal::load_grid<N>(values_path); }), "has values alone, no gradients"));
  CHECK(file_test::contains(error_of([&] { zonal::load_grid<N, GridContent::values>(full_path); }),
                            "has gradients as well"));
}
