// What hvl-render's own comparison cannot show, because both its sides have it: the path tracer against estimators that
// share nothing with it, and materials from files.
#include "hvl-render/direct_light.hpp"
#include "hvl-render/gatherer.hpp"
#include "hvl-render/lit_scene.hpp"
#include "hvl-render/path.hpp"
#include "hvl-render/planned_gather.hpp"
#include "hvl-render/time_budget.hpp"
#include "hvl-render/virtual_lights.hpp"
#include "shared/material_change.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include <zonal/gather/vpl.hpp>

#include "catch.hpp"
#include "files.hpp"
#include "material/merl_writer.hpp"
#include "material/tensor_writer.hpp"
#include "shared/frame.hpp"
#include "shared/input_error.hpp"
#include "shared/materials.hpp"
#include "shared/mesh_builder.hpp"
#include "shared/noise.hpp"
#include "shared/tangents.hpp"

namespace {

using namespace example;
using namespace example::hvl_render;
using file_test::Folder;

constexpr double pi = 3.14159265358979323846;

/// A closed box with a golden floor, a lacquered wall and a ball in it, lit from below its ceiling.
Scene box_scene() {
  Scene scene;
  scene.materials = {{"gold", metal(*find_metal("gold"), 0.3f)},
                     {"chalk", matte({0.8f, 0.6f, 0.4f})},
                     {"lacquer", plastic({0.3f, 0.5f, 0.2f}, 0.4f)}};
  MeshBuilder builder(scene.mesh);
  builder.use(0).quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
  builder.use(1).quad({-1, 2, 1}, {1, 2, 1}, {1, 2, -1}, {-1, 2, -1});
  builder.quad({-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1});
  builder.quad({-1, 0, 1}, {1, 0, 1}, {1, 2, 1}, {-1, 2, 1});
  builder.quad({1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1});
  builder.use(2).quad({-1, 0, -1}, {-1, 0, 1}, {-1, 2, 1}, {-1, 2, -1});
  builder.sphere({0.35f, 0.4f, -0.3f}, 0.3f, 48);
  scene.camera = {{0.0f, 1.2f, 0.9f}, {0.0f, 0.7f, -1.0f}, 1.2f};
  scene.light.position = {-0.3f, 1.8f, 0.2f};
  scene.light.axis = glm::normalize(glm::vec3(0.4f, -1.0f, -0.5f));
  scene.light.half_angle = 0.9f;
  scene.light.intensity = glm::vec3(3.0f, 2.0f, 1.0f);
  return scene;
}

/// Points of every material, matte and glossy, lit and in shadow.
std::vector<Hit> some_hits(const Scene& scene, const RayCaster& caster) {
  std::vector<Hit> hits;
  for (const glm::vec3& target :
       {glm::vec3(-0.4f, 0.0f, -0.2f), glm::vec3(0.5f, 0.0f, 0.3f), glm::vec3(0.2f, 1.5f, -1.0f),
        glm::vec3(-1.0f, 0.8f, -0.4f), glm::vec3(0.3f, 0.6f, -0.1f), glm::vec3(0.0f, 2.0f, 0.0f)}) {
    hits.push_back(*caster.closest(scene.camera.position, glm::normalize(target - scene.camera.position)));
  }
  return hits;
}

glm::vec3 to_camera(const Scene& scene, const Hit& hit) { return glm::normalize(scene.camera.position - hit.position); }

/// side^2 points where light lands.
VirtualLightMap points_of(const Scene& scene, const RayCaster& caster, const MaterialTables& tables, int side) {
  Options options;
  options.method = Method::vpl;
  options.lights = side * side;
  return shoot_virtual_lights(scene, caster, tables, options);
}
VirtualLightMap points_of(const Scene& scene, const RayCaster& caster, int side) {
  return points_of(scene, caster, {}, side);
}

struct Estimate {
  glm::dvec3 mean, deviation;  // of the mean
};

Estimate by_paths(const Scene& scene, const RayCaster& caster, const Hit& hit) {
  constexpr int batches = 64;
  const PathTracer tracer(scene, caster, {2048, 1, 7}, 1);
  glm::dvec3 sum(0.0), squares(0.0);
  for (int batch = 0; batch < batches; ++batch) {
    const glm::dvec3 value(tracer.indirect_radiance(hit, static_cast<std::size_t>(batch)));
    sum += value;
    squares += value * value;
  }
  const glm::dvec3 mean = sum / double(batches);
  return {mean, glm::sqrt(glm::max(squares / double(batches) - mean * mean, 0.0) / double(batches - 1))};
}

/// The rendering equation as it stands: BRDF, cosine and the light that leaves what a ray hits, summed over a grid of
/// directions that is fine about the mirror direction.
glm::dvec3 by_quadrature(const Scene& scene, const RayCaster& caster, const Hit& hit) {
  constexpr int rings = 700, spokes = 1400;
  const Frame frame(hit.normal);
  const glm::vec3 wo = frame.to_local(to_camera(scene, hit));
  const zonal::Brdf brdf = brdf_at(scene, hit);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < rings; ++i) {
    const double z = (i + 0.5) / rings, r = std::sqrt(1.0 - z * z);
    for (int j = 0; j < spokes; ++j) {
      const double phi = 2.0 * pi * (j + 0.5) / spokes;
      const glm::vec3 wi(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
      const glm::vec3 direction = frame.to_world(wi);
      if (glm::dot(direction, hit.geometric_normal) <= 0.0f) continue;
      const auto next = caster.closest_from(hit, direction);
      if (!next) continue;
      sum += glm::dvec3(zonal::evaluate(brdf, wi, wo) * direct_radiance(scene, caster, *next, -direction)) * z;
    }
  }
  return sum * (2.0 * pi / (double(rings) * spokes));
}

/// Light tracing: what a million points on the lit surfaces send here, each by a shadow ray.
glm::dvec3 by_light_tracing(const Scene& scene, const RayCaster& caster, const std::vector<zonal::VirtualLight>& lights,
                            const Hit& hit) {
  const zonal::LightCache cache(lights);
  const auto visible = [&](const glm::vec3& position, const glm::vec3& normal) {
    return caster.visible(hit, Hit{position, normal, normal, 0.0f, 0});
  };
  return glm::dvec3(gather_vpl(cache, {hit.position, hit.normal, to_camera(scene, hit), hit.tangent},
                               brdf_at(scene, hit), 0.0f, visible));
}

std::string error_of(const std::string& change) {
  Scene scene = box_scene();
  try {
    apply({parse_material_change(change)}, scene.materials);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a virtual light that no neighbour is lit beside has the radius that the cone's angle gives") {
  const Scene scene = box_scene();
  const RayCaster caster(scene);
  Options options;
  options.method = Method::vpl;
  options.lights = 1;
  options.radius = RadiusRule::field_of_view;
  const float expected = shoot_virtual_lights(scene, caster, {}, options).lights[0].radius;
  options.radius = RadiusRule::neighbours;
  CHECK(expected > 0.0f);
  CHECK(shoot_virtual_lights(scene, caster, {}, options).lights[0].radius == expected);
}

TEST_CASE("paths agree with brute-force quadrature, and with light tracing, within their error bar") {
  const Scene scene = box_scene();
  const RayCaster caster(scene);
  const auto lights = lit(points_of(scene, caster, 1000));
  REQUIRE(lights.size() > 900000);
  int number = 0;
  for (const Hit& hit : some_hits(scene, caster)) {
    const Estimate paths = by_paths(scene, caster, hit);
    const glm::dvec3 quadrature = by_quadrature(scene, caster, hit);
    const glm::dvec3 tracing = by_light_tracing(scene, caster, lights, hit);
    ++number;
    for (int c = 0; c < 3; ++c) {
      CAPTURE(number, hit.material, c, paths.mean[c], paths.deviation[c], quadrature[c], tracing[c]);
      CHECK(paths.mean[c] > 0.0);
      CHECK(paths.deviation[c] <= 0.003 * paths.mean[c]);
      // 0.2 % for the quadrature's own cells at the edges of shadows, 0.5 % for the last of the light tracer's spikes
      CHECK(std::abs(paths.mean[c] - quadrature[c]) <= 4.0 * paths.deviation[c] + 0.002 * paths.mean[c]);
      CHECK(std::abs(paths.mean[c] - tracing[c]) <= 4.0 * paths.deviation[c] + 0.005 * paths.mean[c]);
    }
  }
}

TEST_CASE("the furnace: paths, and ever so few lights, find the light that an integrating sphere has everywhere") {
  const Scene scene = make_furnace();
  const RayCaster caster(scene);
  const auto map = points_of(scene, caster, 50);
  glm::dvec3 power(0.0);
  for (const zonal::VirtualLight& light : map.lights) power += glm::dvec3(light.flux);
  const double radius = 2.0, albedo = 0.8;
  // Each part of a sphere sends as much to every other: E = albedo times power / area.
  const double expected = albedo / pi * albedo * power.x / (4.0 * pi * radius * radius);
  const PathTracer tracer(scene, caster, {4096, 1, 3}, 1);
  for (const glm::vec3& towards :
       {glm::vec3(0.1f, 0.2f, -1.0f), glm::vec3(0.8f, 0.5f, -0.4f), glm::vec3(0.1f, -0.9f, 0)}) {
    const Hit hit = *caster.closest(scene.camera.position, glm::normalize(towards));
    CHECK(by_light_tracing(scene, caster, map.lights, hit).x == Catch::Approx(expected).epsilon(2e-3));
    CHECK(tracer.indirect_radiance(hit, 1).x == Catch::Approx(expected).epsilon(0.01));
  }
}

namespace {

/// The lights that a budget allows, and how long the picture's gather takes with them on a share of its points.
int lights_within(double seconds, Method method) {
  const Scene scene = box_scene();
  const RayCaster caster(scene);
  Options options;
  options.method = method;
  options.width = options.height = 128;
  options.time_budget = seconds;
  return lights_within_budget(scene, caster, project_materials(scene.materials, options), options);
}

/// The indirect light of a picture within a tolerance, checked at every hit.
struct PlannedPicture {
  Image image{96, 80};
  PlanFigures figures;
};

PlannedPicture planned_picture(const Scene& scene, Options options, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  options.checked_share = 1.0f;
  const RayCaster caster(scene);
  const MaterialTables tables = project_materials(scene.materials, options);
  const VirtualLightMap map = shoot_virtual_lights(scene, caster, tables, options);
  const auto planned = make_planned({scene, caster, tables, map, options}, plan_scene(tables, options));
  Progress progress(false);
  const Stage stage{progress, "", 1.0};
  PlannedPicture picture;
  const Slice slice{0, picture.image.height};
  planned->add(picture.image, trace_primary(caster, scene.camera, picture.image.width, slice.rows, slice, 1, stage),
               stage);
  picture.figures = planned->figures();
  return picture;
}

}  // namespace

TEST_CASE("tolerance: the error is within it and within a factor of five of what is proved; no thread changes a bit") {
  for (const float tolerance : {0.05f, 0.01f}) {
    Options options;
    options.lights = 2500;
    options.tolerance = double(tolerance);
    const PlannedPicture one = planned_picture(box_scene(), options, 1), two = planned_picture(box_scene(), options, 2);
    const PlanFigures& figures = one.figures;
    CAPTURE(tolerance, figures.proved_error(), figures.measured_error(), figures.pairs / double(figures.hits));
    CHECK(figures.hits > 7000);
    CHECK(figures.checked == figures.hits);
    CHECK(figures.measured_error() <= options.tolerance);
    CHECK(figures.proved_error() <= 1.05 * options.tolerance);
    CHECK(figures.proved_error() <= (tolerance < 0.02f ? 5.0 : 12.0) * figures.measured_error());
    CHECK(figures.pairs < 0.7 * 2500.0 * double(figures.hits));
    CHECK(one.image.pixels == two.image.pixels);
  }
}

TEST_CASE("tolerance: holds where rays decide which lights are seen") {
  Options options;
  options.lights = 1024;
  options.tolerance = 0.05;
  options.centre_visibility = true;
  const PlanFigures figures = planned_picture(box_scene(), options, 2).figures;
  CAPTURE(figures.proved_error(), figures.measured_error());
  CHECK(figures.measured_error() <= options.tolerance);
  CHECK(figures.proved_error() <= 1.1 * options.tolerance);
}

TEST_CASE("tolerance: tables of what a plan keeps change the gather by the error of 16 bits, and take a third") {
  const Scene scene = box_scene();
  const RayCaster caster(scene);
  Options options;
  options.tolerance = 0.01;
  MaterialTables tables = project_materials(scene.materials, options);
  const ScenePlan plan = plan_scene(tables, options);
  const auto gathered = [&] {
    const VirtualLightMap map = shoot_virtual_lights(scene, caster, tables, options);
    const auto gatherer = make_gatherer({scene, caster, tables, map, options});
    std::vector<glm::dvec3> radiance;
    for (int i = 0; i < 400; ++i) {  // a lattice of places in the box, and where they are seen
      const glm::vec3 target(-1.0f + 0.1f * static_cast<float>(i % 20), 0.1f * static_cast<float>(i / 20), -1.0f);
      const auto hit = caster.closest(scene.camera.position, glm::normalize(target - scene.camera.position));
      if (hit) radiance.emplace_back(gatherer->indirect_radiance(*hit, to_camera(scene, *hit), 0));
    }
    return radiance;
  };
  const std::vector<glm::dvec3> whole = gathered();
  const TableBytes bytes = keep_planned(tables, plan);
  const std::vector<glm::dvec3> kept = gathered();
  double square = 0.0, error = 0.0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    square += glm::dot(whole[i], whole[i]);
    error += glm::dot(kept[i] - whole[i], kept[i] - whole[i]);
  }
  CAPTURE(plan.half_error, std::sqrt(error / square), bytes.planned, bytes.full);
  CHECK(whole.size() > 300);
  CHECK(plan.coefficient_bits == 16);
  CHECK(error > 0.0);
  CHECK(std::sqrt(error / square) <= plan.half_error);
  CHECK(std::sqrt(error / square) >= plan.half_error / 20);
  CHECK(3 * bytes.planned < bytes.full);
  options.tolerance = 0.005;
  CHECK(plan_scene(project_materials(scene.materials, options), options).coefficient_bits == 32);
}

TEST_CASE("time budget: more time is more lights, and none is one") {
  for (const Method method : {Method::vpl, Method::hvl_zonal, Method::vsgl, Method::vsgl_2024}) {
    const int none = lights_within(1e-6, method), some = lights_within(0.1, method);
    int many = some;  // on the slowest machine a tenth of a second is for one light, and so are some seconds
    for (double seconds = 0.4; many <= some && seconds < 1000.0; seconds *= 4.0) many = lights_within(seconds, method);
    CAPTURE(static_cast<int>(method), some, many);
    CHECK(none == 1);
    CHECK(some < many);
    CHECK(many <= most_lights);
  }
}

TEST_CASE("every method: a finite picture that is not black, with visibility no brighter than without") {
  const Scene scene = box_scene();
  const RayCaster caster(scene);
  const std::vector<Hit> hits = some_hits(scene, caster);
  for (const Method method :
       {Method::vpl, Method::vsl, Method::vsgl, Method::vsgl_2024, Method::hvl, Method::hvl_zonal}) {
    Options options;
    options.method = method;
    options.lights = 400;
    const MaterialTables materials = project_materials(scene.materials, options);
    const VirtualLightMap map = shoot_virtual_lights(scene, caster, materials, options);
    Options seen = options;
    seen.centre_visibility = true;
    const auto all = make_gatherer({scene, caster, materials, map, options});
    const auto visible = make_gatherer({scene, caster, materials, map, seen});
    glm::vec3 sum(0.0f), visible_sum(0.0f);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      sum += all->indirect_radiance(hits[i], to_camera(scene, hits[i]), i);
      visible_sum += visible->indirect_radiance(hits[i], to_camera(scene, hits[i]), i);
    }
    CAPTURE(static_cast<int>(method), sum.x, visible_sum.x);
    for (int c = 0; c < 3; ++c) {
      CHECK(std::isfinite(sum[c]));
      CHECK(visible_sum[c] > 0.0f);
      CHECK(visible_sum[c] <= 1.0001f * sum[c]);
    }
  }
}

namespace {

TextureMap texture_map(int width, int height, const std::vector<std::uint8_t>& rgb) {
  TextureMap map;
  map.texture = std::make_shared<const Texture>(width, height, 3, rgb, TextureUse::values);
  return map;
}

/// With metres as texture coordinates on its walls.
Scene textured_box_scene() {
  Scene scene = box_scene();
  scene.mesh.texture_coordinates.assign(scene.mesh.positions.size(), glm::vec2(0.0f));
  for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
    const glm::vec3 &p = scene.mesh.positions[i], n = glm::abs(scene.mesh.normals[i]);
    scene.mesh.texture_coordinates[i] = n.y > 0.5f ? glm::vec2(p.x, p.z) : n.x > 0.5f ? glm::vec2(p.z, p.y) : p;
  }
  set_tangents(scene.mesh);
  return scene;
}

}  // namespace

TEST_CASE("textures: one of a single colour is the material of that colour, to paths and to every method") {
  const glm::vec3 colour(0.2f, 0.6f, 1.0f);
  Scene plain = textured_box_scene(), textured = plain;
  plain.materials[1].brdf = matte(colour * glm::vec3(0.8f, 0.6f, 0.4f));
  plain.materials[2].brdf = plastic(colour * glm::vec3(0.3f, 0.5f, 0.2f), 0.4f);
  for (const std::size_t material : {1u, 2u}) textured.materials[material].colour = texture_map(1, 1, {51, 153, 255});
  const RayCaster plain_caster(plain), textured_caster(textured);
  const std::vector<Hit> plain_hits = some_hits(plain, plain_caster), hits = some_hits(textured, textured_caster);
  const auto check = [](const glm::vec3& radiance, const glm::vec3& expected, float tolerance) {
    for (int c = 0; c < 3; ++c) {
      CAPTURE(c, radiance[c], expected[c]);
      CHECK(expected[c] > 0.0f);
      CHECK(std::abs(radiance[c] - expected[c]) <= tolerance * expected[c]);
    }
  };
  const PathTracer plain_paths(plain, plain_caster, {64, 2, 7}, 1), paths(textured, textured_caster, {64, 2, 7}, 1);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    CAPTURE(i);
    CHECK(hits[i].material == plain_hits[i].material);
    check(paths.indirect_radiance(hits[i], i), plain_paths.indirect_radiance(plain_hits[i], i), 1e-5f);
  }
  for (const Method method :
       {Method::vpl, Method::vsl, Method::vsgl, Method::vsgl_2024, Method::hvl, Method::hvl_zonal}) {
    Options options;
    options.method = method;
    options.lights = 100;
    const auto radiance = [&](const Scene& scene, const RayCaster& caster, const std::vector<Hit>& at) {
      const MaterialTables tables = project_materials(scene.materials, options);
      const VirtualLightMap map = shoot_virtual_lights(scene, caster, tables, options);
      const auto gatherer = make_gatherer({scene, caster, tables, map, options});
      std::vector<glm::vec3> sums;
      for (const Hit& hit : at) sums.push_back(gatherer->indirect_radiance(hit, to_camera(scene, hit), sums.size()));
      return sums;
    };
    const auto sums = radiance(textured, textured_caster, hits), expected = radiance(plain, plain_caster, plain_hits);
    // A light whose parts stand apart has others beside it, and its own random numbers; and what rings below zero is
    // cut part by part.
    const float tolerance = method == Method::vsl ? 0.05f : method == Method::hvl ? 1e-2f : 1e-5f;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      CAPTURE(static_cast<int>(method), i);
      check(sums[i], expected[i], tolerance);
    }
  }
}

TEST_CASE("textures: paths agree with quadrature and light tracing, which follow them too") {
  Scene scene = textured_box_scene();
  const TextureMap checks = texture_map(2, 2, {255, 51, 51, 51, 255, 51, 51, 51, 255, 255, 255, 255});
  for (const std::size_t material : {1u, 2u}) scene.materials[material].colour = checks;
  const RayCaster caster(scene);
  Options options;
  options.method = Method::vpl;
  const MaterialTables tables = project_materials(scene.materials, options);
  const auto lights = lit(points_of(scene, caster, tables, 1000));
  for (const Hit& hit : some_hits(scene, caster)) {
    const Estimate paths = by_paths(scene, caster, hit);
    const glm::dvec3 quadrature = by_quadrature(scene, caster, hit);
    const glm::dvec3 tracing = by_light_tracing(scene, caster, lights, hit);
    for (int c = 0; c < 3; ++c) {
      CAPTURE(hit.material, c, paths.mean[c], paths.deviation[c], quadrature[c], tracing[c]);
      CHECK(std::abs(paths.mean[c] - quadrature[c]) <= 4.0 * paths.deviation[c] + 0.002 * paths.mean[c]);
      CHECK(std::abs(paths.mean[c] - tracing[c]) <= 4.0 * paths.deviation[c] + 0.005 * paths.mean[c]);
    }
  }
}

TEST_CASE("relief: paths agree with quadrature, and with light tracing from matte reliefs") {
  Relief relief;
  relief.map.texture = std::make_shared<const Texture>(noise_heights(256, 8, 3, 1));
  relief.map.scale = glm::vec2(1.0f / 1.5f);
  relief.strength = 0.12f;
  for (const bool everywhere : {false, true}) {
    Scene scene = textured_box_scene();
    for (Material& material : scene.materials) {
      if (everywhere || material.name == "chalk") material.relief = relief;
    }
    const RayCaster caster(scene);
    Options options;
    options.method = Method::vpl;
    const MaterialTables tables = project_materials(scene.materials, options);
    const VirtualLightMap map = points_of(scene, caster, tables, 1000);
    const auto lights = lit(map);
    // Of chalk the body alone sends light, of gold the rest, of lacquer both.
    int bodies = 0, rests = 0, nothing = 0;
    for (std::size_t i = 0; i < map.lights.size(); ++i) {
      if (!is_lit(map.lights[i])) continue;
      bodies += is_lit(map.bodies[i]), rests += map.lights[i].brdf != nullptr;
      nothing += !is_lit(map.bodies[i]) && map.lights[i].brdf == nullptr;
    }
    CHECK(nothing == 0);
    CHECK((bodies > 0 && rests > 0));
    CHECK((bodies + rests > static_cast<int>(map.lights.size())) == everywhere);
    for (const Hit& hit : some_hits(scene, caster)) {
      const Estimate paths = by_paths(scene, caster, hit);
      const glm::dvec3 quadrature = by_quadrature(scene, caster, hit);
      const glm::dvec3 tracing = by_light_tracing(scene, caster, lights, hit);
      for (int c = 0; c < 3; ++c) {
        CAPTURE(everywhere, hit.material, c, paths.mean[c], paths.deviation[c], quadrature[c], tracing[c]);
        CHECK(std::abs(paths.mean[c] - quadrature[c]) <= 4.0 * paths.deviation[c] + 0.003 * paths.mean[c]);
        // The lights of glossy reliefs are an approximation.
        if (everywhere) continue;
        CHECK(std::abs(paths.mean[c] - tracing[c]) <= 4.0 * paths.deviation[c] + 0.005 * paths.mean[c]);
      }
    }
  }
}

TEST_CASE("materials: a MERL file replaces a model, for values and for sampling") {
  const Folder folder;
  const auto path = folder.path / "copper.binary";
  const zonal::Brdf copper = metal(*find_metal("copper"), 0.3f);
  file_test::write(path, material_test::merl_bytes(copper));
  Scene scene = box_scene();
  apply({parse_material_change("gold=" + path.string())}, scene.materials);
  CHECK(scene.materials[0].file == path);
  CHECK(scene.materials[1].file.empty());
  material_test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 wi = random.direction(), wo = random.direction();
    if (std::min(wi.z, wo.z) < 0.3f) continue;
    const glm::vec3 expected = zonal::evaluate(copper, wi, wo), got = zonal::evaluate(scene.materials[0].brdf, wi, wo);
    CAPTURE(i);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(got[c] - expected[c]) <= 0.01f);
  }
}

namespace {

/// The one table in a folder, named after its source and its fingerprint.
std::filesystem::path only_table(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> tables;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".table") tables.push_back(entry.path());
  }
  REQUIRE(tables.size() == 1);
  CHECK(file_test::contains(tables[0].filename().string(), "copper-"));
  return tables[0];
}

}  // namespace

TEST_CASE("materials: a file is projected once, for all materials and under all its names") {
  const Folder folder;
  material_test::RglGrid grid;
  grid.theta_nodes = 3;
  grid.square = grid.rgb = 8;
  for (const char* name : {"copper-1.bsdf", "copper-2.bsdf"}) {
    file_test::write(folder.path / name, material_test::tensor_file(material_test::rgl_tensors({0.5, 0.5}, grid)));
  }
  Scene scene = box_scene();
  scene.materials.resize(2, scene.materials[0]);
  scene.materials[0].name = "a", scene.materials[1].name = "b";
  apply({parse_material_change("a=" + (folder.path / "copper-1.bsdf").string()),
         parse_material_change("b=" + (folder.path / "copper-2.bsdf").string())},
        scene.materials);
  Options options;
  options.material_cache = (folder.path / "cache").string();
  const auto tables = project_materials(scene.materials, options);
  only_table(options.material_cache);
  REQUIRE(tables.receiving.size() == 2);
  CHECK(tables.receiving[0].whole().with_cosine_rows() == tables.receiving[1].whole().with_cosine_rows());
  // another file of the same name is another material
  file_test::write(folder.path / "copper-1.bsdf",
                   material_test::tensor_file(material_test::rgl_tensors({0.4, 0.4}, grid)));
  apply({parse_material_change("a=" + (folder.path / "copper-1.bsdf").string())}, scene.materials);
  const auto changed = project_materials(scene.materials, options);
  CHECK(changed.receiving[0].whole().with_cosine_rows() != tables.receiving[0].whole().with_cosine_rows());
  CHECK(changed.receiving[1].whole().with_cosine_rows() == tables.receiving[1].whole().with_cosine_rows());
}

TEST_CASE("materials: the cache of projections is written once, and read") {
  const Folder folder;
  file_test::write(folder.path / "copper.binary", material_test::merl_bytes(metal(*find_metal("copper"), 0.3f)));
  Scene scene = box_scene();
  apply({parse_material_change("gold=" + (folder.path / "copper.binary").string())}, scene.materials);
  Options options;
  options.material_cache = folder.path.string();
  const auto built = project_materials(scene.materials, options);
  const auto table = only_table(folder.path);
  const auto written = std::filesystem::last_write_time(table);
  const auto read = project_materials(scene.materials, options);
  CHECK(std::filesystem::last_write_time(table) == written);
  CHECK(read.receiving[0].whole().with_cosine_rows() == built.receiving[0].whole().with_cosine_rows());
}

TEST_CASE("materials: the cache's directory is made; where it cannot be, that is bad input") {
  const Folder folder;
  file_test::write(folder.path / "copper.binary", material_test::merl_bytes(metal(*find_metal("copper"), 0.3f)));
  Scene scene = box_scene();
  apply({parse_material_change("gold=" + (folder.path / "copper.binary").string())}, scene.materials);
  Options options;
  options.material_cache = (folder.path / "copper.binary" / "cache").string();
  CHECK_THROWS_AS(project_materials(scene.materials, options), InputError);
  options.material_cache = (folder.path / "cache").string();
  project_materials(scene.materials, options);
  const auto table = only_table(options.material_cache);
  file_test::write(table, "something else");
  CHECK_THROWS_AS(project_materials(scene.materials, options), InputError);
}

TEST_CASE("materials: an anisotropic file is gathered in the surface's own frame, by every method that takes it") {
  const Folder folder;
  const std::string file = (folder.path / "x.bsdf").string();
  material_test::RglGrid grid;
  grid.phi_nodes = 5;
  grid.theta_nodes = 3;
  grid.square = grid.rgb = 12;
  file_test::write(file, material_test::tensor_file(material_test::rgl_tensors({0.3, 0.7}, grid)));
  Scene scene = box_scene();
  apply({parse_material_change("*=" + file)}, scene.materials);
  for (const Material& material : scene.materials) CHECK_FALSE(is_isotropic(material.brdf));
  const RayCaster caster(scene);
  Options options;
  options.lights = 4;
  options.bands = 3;
  options.emission_bands = 3;
  options.method = Method::hvl;
  const MaterialTables tables = project_materials(scene.materials, options);
  REQUIRE(tables.anisotropic.size() == scene.materials.size());
  REQUIRE(tables.anisotropic[0] != nullptr);
  CHECK(tables.anisotropic[0] == tables.anisotropic.back());
  CHECK(tables.anisotropic[0]->rows_built() == 0);
  const std::optional<Hit> hit =
      caster.closest(scene.camera.position, glm::normalize(scene.camera.target - scene.camera.position));
  REQUIRE(hit);
  CHECK(std::abs(hit->tangent.y) <= 1e-6f);
  for (const Method method : {Method::hvl, Method::vpl, Method::vsl, Method::vsgl, Method::vsgl_2024}) {
    options.method = method;
    const MaterialTables own = method == Method::hvl ? tables : project_materials(scene.materials, options);
    const VirtualLightMap map = shoot_virtual_lights(scene, caster, own, options);
    const auto gatherer = make_gatherer({scene, caster, own, map, options});
    const glm::vec3 radiance = gatherer->indirect_radiance(*hit, to_camera(scene, *hit), 0);
    CAPTURE(static_cast<int>(method), radiance.x, radiance.y, radiance.z);
    for (int c = 0; c < 3; ++c) CHECK((std::isfinite(radiance[c]) && radiance[c] >= 0.0f));
  }
  CHECK(tables.anisotropic[0]->rows_built() > 0);
  // A relief of no slope is none, and a file's material has no body.
  Scene flat = textured_box_scene();
  apply({parse_material_change("*=" + file)}, flat.materials);
  for (Material& material : flat.materials) material.relief.map = texture_map(1, 1, {7, 7, 7});
  const RayCaster flat_caster(flat);
  options.method = Method::hvl;
  const MaterialTables flat_tables = project_materials(flat.materials, options);
  const VirtualLightMap flat_map = shoot_virtual_lights(flat, flat_caster, flat_tables, options);
  CHECK(lit(flat_map).size() == lit(shoot_virtual_lights(scene, caster, tables, options)).size());
  CHECK(flat_tables.anisotropic[0] != nullptr);
  // Paths know nothing of virtual lights, but of the same frames.
  const auto lights = lit(points_of(scene, caster, 200));
  const PathTracer tracer(scene, caster, {16384, 1, 7}, 1);
  for (const Hit& at : some_hits(scene, caster)) {
    const glm::dvec3 tracing = by_light_tracing(scene, caster, lights, at), paths(tracer.indirect_radiance(at, 1));
    CAPTURE(at.normal.x, at.normal.y, at.normal.z, tracing.x, paths.x);
    CHECK(std::abs(tracing.x - paths.x) <= 0.04 * paths.x);
  }
  options.method = Method::hvl_zonal;
  CHECK_THROWS_AS(project_materials(scene.materials, options), InputError);
}

TEST_CASE("materials: light between microfacets is added to metals alone, where it is asked for") {
  Options options;
  const auto red_of = [&options](const std::string& name) {
    const Scene scene = load_scene(options);
    for (const Material& material : scene.materials) {
      if (material.name != name) continue;
      double sum = 0.0;  // of uniform light, seen from the normal
      constexpr int rings = 400;
      for (int i = 0; i < rings; ++i) {
        const double z = (i + 0.5) / rings, s = std::sqrt(1.0 - z * z);
        const glm::dvec3 wi(s, 0.0, z);
        sum += zonal::evaluate(material.brdf, wi, glm::dvec3(0.0, 0.0, 1.0)).x * z * 2.0 * glm::pi<double>() / rings;
      }
      return sum;
    }
    return -1.0;
  };
  options.materials = {parse_material_change("gold=silver:1"), parse_material_change("plaster=plastic:0.5,0.5,0.5,1")};
  const double metal = red_of("gold"), plastic = red_of("plaster");
  options.multiple_scattering = true;
  CAPTURE(metal, red_of("gold"));
  CHECK(metal < 0.35);  // 31 %
  CHECK((red_of("gold") > 0.9 && red_of("gold") < 1.0));
  CHECK(red_of("plaster") == plastic);
}

TEST_CASE("materials: what is wrong with a file is said in one line") {
  using file_test::contains;
  const Folder folder;
  const std::string merl = (folder.path / "x.binary").string(), rgl = (folder.path / "x.bsdf").string();
  CHECK(contains(error_of("gold=" + merl), "x.binary: "));
  file_test::write(merl, "short");
  CHECK(contains(error_of("gold=" + merl), "x.binary: has 5 bytes"));
  file_test::write(rgl, "no tensors");
  CHECK(contains(error_of("gold=" + rgl), "x.bsdf: "));
  material_test::RglGrid grid;
  file_test::write(rgl, material_test::tensor_file(material_test::rgl_tensors({0.3, 0.3}, grid)));
  CHECK(error_of("gold=" + rgl).empty());
  for (const std::string& text : {error_of("gold=" + merl), error_of("brass=gold"), error_of("gold=brass")}) {
    CHECK(!text.empty());
    CHECK(!contains(text, "\n"));
  }
}
