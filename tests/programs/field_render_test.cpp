// Things in light that is known: constant, of one lamp, and the truth itself at a grid's vertices.
#include "field-render/grid_light.hpp"
#include "field-render/inserted.hpp"
#include "field-render/reference.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <zonal/grid/grid_file.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/material/named.hpp>

#include "catch.hpp"
#include "shared/input_error.hpp"

namespace {

using namespace example;
using namespace example::field_render;

/// A file as long as this lives.
struct GridFile {
  template <int N, zonal::GridContent content>
  explicit GridFile(const zonal::CoefficientGrid<N, content>& grid) {
    zonal::save_grid(path, grid);
  }
  ~GridFile() { std::filesystem::remove(path); }
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("zonal_field_render_test_" + std::to_string(getpid()) + ".grid");
};

/// Level, at a place, in some scene without tangents.
Hit hit_at(const glm::vec3& position) {
  Hit hit{};
  hit.position = position;
  hit.normal = hit.geometric_normal = {0.0f, 1.0f, 0.0f};
  hit.tangent = {1.0f, 0.0f, 0.0f};
  return hit;
}

const glm::vec3 outgoing = glm::normalize(glm::vec3(0.4f, 0.8f, 0.3f));

void check_close(const glm::vec3& got, const glm::vec3& expected, float share) {
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, got[c], expected[c]);
    CHECK(std::abs(got[c] - expected[c]) <= share * expected[c]);
  }
}

/// A grid of one coefficient everywhere: radiance from all around.
template <int N, zonal::GridContent content>
zonal::CoefficientGrid<N, content> constant_grid(const glm::vec3& radiance) {
  zonal::CoefficientGrid<N, content> grid(glm::vec3(0.0f), glm::vec3(1.0f), glm::ivec3(2));
  zonal::Sh<N, glm::vec3> value{};
  value[0] = radiance * std::sqrt(4.0f * 3.14159265f);
  for (int i = 0; i < 8; ++i) grid.set(glm::ivec3(i & 1, i >> 1 & 1, i >> 2), value);
  return grid;
}

TEST_CASE("light that is the same all around: matte surfaces send out their albedo of it, by any grid") {
  const glm::vec3 radiance(2.0f, 1.0f, 0.5f), albedo(0.8f, 0.4f, 0.2f);
  const SplitMaterial matte({"matte", zonal::matte(albedo)});
  const auto check = [&](const auto& grid, zonal::Interpolation interpolation) {
    const GridFile file(grid);
    const auto light = load_grid_light(file.path, interpolation);
    check_close(light->reflected(hit_at({0.3f, 0.2f, 0.9f}), outgoing, matte, {}), albedo * radiance, 1e-5f);
  };
  using zonal::GridContent;
  using zonal::Interpolation;
  check(constant_grid<3, GridContent::values>(radiance), Interpolation::trilinear);
  check(constant_grid<4, GridContent::values_and_gradients>(radiance), Interpolation::hermite);
  check(constant_grid<5, GridContent::values_and_gradients>(radiance), Interpolation::trilinear);
  check(constant_grid<6, GridContent::values>(radiance), Interpolation::trilinear);
}

TEST_CASE("grids that cannot be used are refused") {
  using zonal::GridContent;
  const glm::vec3 white(1.0f);
  CHECK_THROWS_AS(
      load_grid_light(GridFile(constant_grid<2, GridContent::values>(white)).path, zonal::Interpolation::trilinear),
      InputError);
  CHECK_THROWS_AS(
      load_grid_light(GridFile(constant_grid<7, GridContent::values>(white)).path, zonal::Interpolation::trilinear),
      InputError);
  CHECK_THROWS_AS(
      load_grid_light(GridFile(constant_grid<5, GridContent::values>(white)).path, zonal::Interpolation::hermite),
      InputError);
}

TEST_CASE("paths in a shining sphere, and straight from a lamp, are what they must be") {
  Scene scene = make_furnace();
  scene.materials[0] = {"shining", zonal::Brdf{}};
  scene.materials[0].emission = {3.0f, 2.0f, 1.0f};
  const RayCaster caster(scene);
  const zonal::Brdf matte = zonal::matte(glm::vec3(0.5f));
  const Hit hit = hit_at({0.2f, 0.1f, 0.3f});
  const IncidentRadiance dark(scene, caster, {}, 2);
  check_close(true_radiance(dark, matte, hit, outgoing, 16, 1), {1.5f, 1.0f, 0.5f}, 1e-5f);

  scene.materials[0].emission = glm::vec3(0.0f);
  const glm::vec3 lamp(0.7f, 0.9f, 0.2f);
  const float radius = 0.01f, radiance = 100.0f;
  const IncidentRadiance lit(
      scene, caster, {Emitter::projector(lamp, hit.position, radius, Emitter::Beam::even, 0.0f, glm::vec3(radiance))},
      0);
  const glm::vec3 offset = lamp - hit.position;
  const float squared_distance = glm::dot(offset, offset), cosine = offset.y / std::sqrt(squared_distance);
  // A disc that faces the place: E = pi L sin^2 cos.
  const float expected = 0.5f * radiance * radius * radius / (squared_distance + radius * radius) * cosine;
  check_close(true_radiance(lit, matte, hit, outgoing, 64, 1), glm::vec3(expected), 1e-3f);
}

TEST_CASE("a lamp's own coefficients in the grid and paths from the thing to it agree") {
  // A small disc, even, that faces the box from afar, is nearly a sphere of its radius.
  const glm::vec3 lamp(0.5f, 5.0f, 3.0f), centre(0.5f);
  const float radius = 0.2f;
  const glm::vec3 radiance(90.0f, 60.0f, 30.0f);
  constexpr int N = 6;
  zonal::CoefficientGrid<N, zonal::GridContent::values> grid(glm::vec3(0.0f), glm::vec3(1.0f), glm::ivec3(9));
  const zonal::SphereLight<float> sphere{lamp, radius};
  for (int k = 0; k < 9; ++k) {
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < 9; ++i) {
        const auto seen = zonal::project<N>(sphere, grid.position({i, j, k}));
        zonal::Sh<N, glm::vec3> value;
        for (int c = 0; c < N * N; ++c) value[c] = seen[c] * radiance;
        grid.set({i, j, k}, value);
      }
    }
  }
  const GridFile file(grid);
  const auto light = load_grid_light(file.path, zonal::Interpolation::trilinear);
  Scene scene = make_furnace();
  scene.materials[0] = {"black", zonal::Brdf{}};
  for (glm::vec3& position : scene.mesh.positions) position *= 10.0f;
  const RayCaster caster(scene);
  const IncidentRadiance paths(scene, caster,
                               {Emitter::projector(lamp, centre, radius, Emitter::Beam::even, 0.0f, radiance)}, 0);
  const glm::vec3 eye = glm::normalize(glm::vec3(0.1f, 4.5f, -2.5f));  // about where the lamp is mirrored
  const struct {
    const char* name;
    zonal::Brdf brdf;
    float bound;
  } cases[] = {{"matte", zonal::matte(glm::vec3(0.6f)), 0.03f},
               {"phong", {{zonal::PhongBrdf{glm::vec3(0.6f), 4.0f}}}, 0.03f},
               {"plastic", zonal::plastic(glm::vec3(0.5f), 0.7f), 0.03f}};
  for (const auto& [name, brdf, bound] : cases) {
    const SplitMaterial material({name, brdf});
    for (const glm::vec3& place : {glm::vec3(0.5f), glm::vec3(0.13f, 0.81f, 0.37f)}) {
      CAPTURE(name, place.x);
      check_close(light->reflected(hit_at(place), eye, material, {N}),
                  true_radiance(paths, brdf, hit_at(place), eye, 256, 3), bound);
    }
  }
}

TEST_CASE("what is inserted stands in the box, seen by its camera") {
  const Bounds box{{1.0f, 2.0f, 3.0f}, {3.0f, 4.0f, 5.0f}};
  for (const char* object : {"table", "figures"}) {
    Options options;
    options.object = object;
    const Scene scene = make_inserted(options, box);
    const Bounds bounds = bounds_of(scene.mesh);
    CAPTURE(object);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(bounds.lower[axis] >= box.lower[axis]);
      CHECK(bounds.upper[axis] <= box.upper[axis]);
    }
    const RayCaster caster(scene);
    CHECK(caster.closest(scene.camera.position, glm::normalize(scene.camera.target - scene.camera.position)));
  }
}

}  // namespace
