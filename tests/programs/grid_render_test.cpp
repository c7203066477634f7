// What grid-render's own comparison cannot show, because both its sides have it: the shading against plain quadratures
// of the materials, and the lights.
#include "grid-render/grid_plan.hpp"
#include "grid-render/lighting_bands.hpp"
#include "grid-render/lights.hpp"
#include "grid-render/zonal_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <tbb/global_control.h>

#include "catch.hpp"
#include "shared/frame.hpp"

namespace {

using namespace example;
using namespace example::grid_render;

constexpr double pi = 3.14159265358979323846;

/// The integral of BRDF and cosine over a cap of directions, by midpoints.
glm::dvec3 integral_over_cap(const zonal::Brdf& brdf, const glm::dvec3& wo, const glm::vec3& axis, double cos_angle) {
  constexpr int rows = 200, columns = 400;
  const Frame frame(axis);
  glm::dvec3 sum(0.0);
  for (int row = 0; row < rows; ++row) {
    const double z = cos_angle + (1.0 - cos_angle) * (row + 0.5) / rows, r = std::sqrt((1.0 - z) * (1.0 + z));
    for (int column = 0; column < columns; ++column) {
      const double phi = 2.0 * pi * (column + 0.5) / columns;
      const glm::dvec3 wi(frame.to_world(glm::vec3(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z))));
      sum += zonal::evaluate(brdf, wi, wo) * std::max(wi.z, 0.0);
    }
  }
  return sum * (2.0 * pi * (1.0 - cos_angle) / (rows * columns));
}

glm::vec3 direction(double degrees) {
  return {static_cast<float>(std::sin(degrees * pi / 180.0)), 0.0f, static_cast<float>(std::cos(degrees * pi / 180.0))};
}

Reflector reflector_of(const zonal::Brdf& brdf, int bands) {
  Options options;
  options.bands = bands;
  return project_materials({{"", brdf}}, options).front();
}

/// A surface at the origin that looks up z.
Hit surface() { return {glm::vec3(0.0f), direction(0.0), direction(0.0), 1.0f, 0}; }

void check_close(const glm::vec3& got, const glm::dvec3& expected, double share) {
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, expected[c]);
    CHECK(std::abs(static_cast<double>(got[c]) - expected[c]) <= share * expected[c]);
  }
}

const zonal::Brdf chalk{{zonal::LambertBrdf{{0.8f, 0.5f, 0.2f}}}};
const zonal::Brdf gold{{zonal::GgxBrdf{0.5f, zonal::ConductorFresnel{{0.14f, 0.37f, 1.44f}, {3.98f, 2.39f, 1.60f}}}}};
const zonal::Brdf shiny{{zonal::PhongBrdf{{0.3f, 0.4f, 0.5f}, 20.0f}}};

LightPanel panel_of(float half_u, float half_v) {
  return {{0.0f, 3.0f, 0.0f}, {half_u, 0.0f, 0.0f}, {0.0f, 0.0f, half_v}, 3.0f};
}

double disc_area(const SphereLights& lights) {
  double sum = 0.0;
  for (const auto& [light, colour] : lights) sum += pi * static_cast<double>(light.radius * light.radius);
  return sum;
}

}  // namespace

TEST_CASE("shading: a texture colours what is diffuse, and nothing else") {
  const glm::vec3 colour(0.25f, 0.5f, 1.0f), to_eye = direction(40.0);
  zonal::Sh<5, glm::vec3> sky{};
  for (int i = 0; i < sky.size(); ++i) sky[i] = glm::vec3(1.0f / static_cast<float>(i + 1));
  Hit coloured = surface();
  coloured.colour = colour;
  check_close(reflect(sky, coloured, to_eye, reflector_of(chalk, 5)),
              colour * reflect(sky, surface(), to_eye, reflector_of(chalk, 5)), 1e-6);
  for (const zonal::Brdf* brdf : {&gold, &shiny}) {
    check_close(reflect(sky, coloured, to_eye, reflector_of(*brdf, 5)),
                reflect(sky, surface(), to_eye, reflector_of(*brdf, 5)), 0.0);
  }
}

TEST_CASE("shading: under an even sky every material reflects its albedo") {
  zonal::Sh<5, glm::vec3> sky{};
  sky[0] = glm::vec3(static_cast<float>(2.0 * std::sqrt(pi)));
  for (const zonal::Brdf* brdf : {&chalk, &gold, &shiny}) {
    for (const double degrees : {0.0, 30.0, 60.0}) {
      CAPTURE(degrees);
      const glm::vec3 to_eye = direction(degrees);
      check_close(reflect(sky, surface(), to_eye, reflector_of(*brdf, 5)),
                  integral_over_cap(*brdf, glm::dvec3(to_eye), direction(0.0), 0.0), 2e-3);
    }
  }
}

namespace {

/// A sphere of half angle 30 degrees and radiance 2, seen at an angle in the plane of the eye; the eye at another.
void check_sphere_light(const zonal::Brdf& brdf, double light_degrees, double eye_degrees, double share) {
  CAPTURE(light_degrees, eye_degrees);
  const SphereLights lights{{{3.0f * direction(light_degrees), 1.5f}, glm::vec3(2.0f)}};
  const glm::vec3 to_eye = direction(eye_degrees);
  const glm::vec3 got =
      make_lighting(Shape::spheres, lights, {}, 9)->exact()->reflected(surface(), to_eye, reflector_of(brdf, 9));
  const glm::dvec3 integral = integral_over_cap(brdf, glm::dvec3(to_eye), direction(light_degrees), std::cos(pi / 6.0));
  check_close(got, 2.0 * integral, share);
}

}  // namespace

TEST_CASE("shading: a sphere light above, seen from the normal") {
  for (const double degrees : {0.0, 20.0, 40.0}) check_sphere_light(chalk, degrees, 0.0, 0.01);
  for (const double degrees : {0.0, 20.0}) check_sphere_light(gold, degrees, 0.0, 0.03);
}

TEST_CASE("shading: a sphere light in the mirror direction, where the lobe of the normal stands for the true one") {
  check_sphere_light(gold, -40.0, 40.0, 0.12);  // what the split sum costs there
  check_sphere_light(shiny, -40.0, 40.0, 0.1);
}

TEST_CASE("shading: zonal by zonal, a diffuse surface reflects solid angle times the cosine of the centre") {
  const Reflector reflector = reflector_of(chalk, 5);
  for (const double degrees : {0.0, 40.0, 80.0, 120.0}) {
    CAPTURE(degrees);
    const SphereLights lights{{{3.0f * direction(degrees), 1.5f}, glm::vec3(2.0f)}};
    const glm::vec3 got = make_zonal_field(lights, 5)->reflected(surface(), direction(30.0), reflector);
    const double solid_angle = 2.0 * pi * (1.0 - std::cos(pi / 6.0));
    const double cosine = std::max(0.0, std::cos(degrees * pi / 180.0));
    check_close(got, 2.0 / pi * solid_angle * cosine * glm::dvec3(0.8, 0.5, 0.2), 1e-5);
  }
}

TEST_CASE("shading: zonal by zonal, a small light in the midst of a lobe is as bright as with the exact cosine") {
  const SphereLights lights{{{3.0f * direction(-20.0), 0.05f}, glm::vec3(2.0f)}};
  for (const zonal::Brdf* brdf : {&chalk, &gold, &shiny}) {
    const Reflector reflector = reflector_of(*brdf, 9);
    const glm::vec3 exact =
        make_lighting(Shape::spheres, lights, {}, 9)->exact()->reflected(surface(), direction(20.0), reflector);
    const glm::vec3 zonal = make_zonal_field(lights, 9)->reflected(surface(), direction(20.0), reflector);
    check_close(zonal, glm::dvec3(exact), 0.06);
  }
}

TEST_CASE("triangles: two for a sphere, as large as its disc, and parallel to the panel") {
  const LightPanel panel = panel_of(1.0f, 2.0f);
  const SphereLights spheres = make_lanterns(panel, 7);
  const TriangleLights triangles = triangles_of(spheres, panel);
  const TriangleSphereLights approximated = triangle_spheres_of(triangles);
  REQUIRE(triangles.size() == 2 * spheres.size());
  REQUIRE(approximated.size() == triangles.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    glm::vec3 centre(0.0f);
    double area = 0.0;
    for (const std::size_t k : {2 * i, 2 * i + 1}) {
      CHECK(triangles[k].colour == spheres[i].colour);
      CHECK(std::abs(approximated[k].light.normal.y) == Catch::Approx(1.0));
      centre += 0.5f * approximated[k].light.center;
      area += pi * static_cast<double>(approximated[k].light.radius * approximated[k].light.radius);
    }
    CHECK(glm::distance(centre, spheres[i].light.center) < 1e-5f);
    CHECK(area == Catch::Approx(pi * static_cast<double>(spheres[i].light.radius * spheres[i].light.radius)));
  }
}

TEST_CASE("triangles: a point sees the sum of the polygons, each by itself in double") {
  const LightPanel panel = panel_of(1.0f, 2.0f);
  const TriangleLights lights = triangles_of(make_lanterns(panel, 11), panel);
  const ExactField<5, Triangle> field(lights);
  for (const glm::vec3& x : {glm::vec3(0.0f), glm::vec3(2.0f, 4.5f, -1.0f), glm::vec3(0.3f, 2.0f, 1.7f)}) {
    zonal::Sh<5, glm::dvec3> expected{};
    for (const auto& [light, colour] : lights) {
      const auto& p = light.vertices;
      const zonal::TriangleLight<double> wide{{glm::dvec3(p[0]), glm::dvec3(p[1]), glm::dvec3(p[2])}};
      const auto sh = zonal::project<5>(wide, glm::dvec3(x), 1e-10);
      for (int i = 0; i < 25; ++i) expected[i] += sh[i] * glm::dvec3(colour);
    }
    const auto got = field.at(x);
    for (int i = 0; i < 25; ++i) {
      CAPTURE(i);
      for (int c = 0; c < 3; ++c)
        CHECK(std::abs(static_cast<double>(got[i][c]) - expected[i][c]) < 1e-4 * expected[0][c]);
    }
  }
}

TEST_CASE("lanterns: as many as asked for, as bright whatever their number, clear of the hall") {
  const Scene atrium = make_atrium();
  const RayCaster caster(atrium);
  for (const int count : {1, 2, 7, 648, 2000}) {
    Options options;
    options.lights = count;
    const SphereLights lights = make_lights(atrium, options);
    REQUIRE(lights.size() == static_cast<std::size_t>(count));
    double brightness = 0.0;
    float clearance = std::numeric_limits<float>::infinity();
    for (const auto& [light, colour] : lights) {
      brightness += static_cast<double>(light.radius * light.radius * (colour.r + colour.g + colour.b) / 3.0f);
      for (int i = 0; i < 27; ++i) {
        const glm::vec3 towards(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (i == 13) continue;
        const std::optional<Hit> hit = caster.closest(light.center, glm::normalize(towards));
        if (hit) clearance = std::min(clearance, hit->distance - light.radius);
      }
    }
    CAPTURE(count);
    CHECK(brightness == Catch::Approx(atrium.panel.distance * atrium.panel.distance).epsilon(1e-4));
    CHECK(clearance > (count < 10 ? 0.0f : 1.0f));
  }
}

TEST_CASE("textures: spheres fill the panel and keep the picture's light") {
  const LightPanel panel = panel_of(1.0f, 2.0f);
  Image picture(8, 16);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    picture.pixels[i] = glm::vec3(1.0f + static_cast<float>(i % 7), 2.0f, 1.0f + static_cast<float>(i % 3));
  }
  const auto light_of = [](const SphereLights& lights) {
    glm::dvec3 sum(0.0);
    for (const auto& [light, colour] : lights) {
      sum += glm::dvec3(colour) * (pi * static_cast<double>(light.radius * light.radius));
    }
    return sum;
  };
  const SphereLights all = make_texture_lights(panel, picture, std::nullopt);
  CHECK(all.size() == 8 * 16);
  std::size_t before = all.size();
  for (const float bound : {0.0f, 0.5f, 1.2f, 1000.0f}) {
    const SphereLights lights = make_texture_lights(panel, picture, bound);
    CAPTURE(bound, lights.size());
    CHECK(lights.size() <= before);
    before = lights.size();
    CHECK(disc_area(lights) == Catch::Approx(static_cast<double>(panel.area())).epsilon(1e-5));
    check_close(light_of(lights), light_of(all), 1e-5);
  }
  CHECK(before == 1);
}

TEST_CASE("textures: blocks of one colour become one light, and black ones none") {
  const LightPanel panel = panel_of(1.0f, 1.0f);
  Image picture(8, 8);
  for (int y = 0; y < 4; ++y) {
    for (int x = 4; x < 8; ++x) picture.at(x, y) = glm::vec3(1.0f, 2.0f, 3.0f);
  }
  const SphereLights lights = make_texture_lights(panel, picture, 0.0f);
  REQUIRE(lights.size() == 1);
  CHECK(lights[0].colour == glm::vec3(1.0f, 2.0f, 3.0f));
  CHECK(glm::distance(lights[0].light.center, glm::vec3(0.5f, 3.0f, 0.5f)) < 1e-6f);
  CHECK(make_texture_lights(panel, picture, std::nullopt).size() == 16);
}

TEST_CASE("textures: resampling keeps the mean, whatever the sizes") {
  Image picture(5, 3);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] = glm::vec3(static_cast<float>(i * i));
  const auto mean = [](const Image& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3& pixel : image.pixels) sum += pixel;
    return sum / static_cast<double>(image.pixels.size());
  };
  for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(2, 2), glm::ivec2(5, 3), glm::ivec2(13, 7)}) {
    const Image resampled = resample(picture, size.x, size.y);
    REQUIRE(resampled.width == size.x);
    REQUIRE(resampled.height == size.y);
    check_close(mean(resampled), mean(picture), 1e-5);
  }
  CHECK(resample(picture, 5, 3).pixels == picture.pixels);
}

namespace {

/// A box of 4 x 3 x 5 m seen from its middle, chalk, gold and a shiny wall; and sphere lights in it, the first of which
/// hang some centimetres before the walls.
struct LitBox {
  Bounds box{glm::vec3(0.0f), glm::vec3(4.0f, 3.0f, 5.0f)};
  std::vector<Reflector> reflectors;
  SphereLights lights;
  Options options;

  LitBox(int near_walls, int others, int bands) {
    options.bands = bands;
    reflectors = project_materials({{"", chalk}, {"", gold}, {"", shiny}}, options);
    std::mt19937 engine(5);
    const auto within = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); };
    const auto anywhere = [&] { return glm::vec3(within(0.5f, 3.5f), within(0.5f, 2.5f), within(0.5f, 4.5f)); };
    for (int i = 0; i < near_walls + others; ++i) {
      glm::vec3 centre = anywhere();
      if (i < near_walls) centre[i % 3] = 0.08f;
      lights.push_back({{centre, 0.03f}, glm::vec3(within(100.0f, 200.0f))});
    }
  }

  /// Points of the walls, in turn of the three materials.
  std::vector<SeenHit> hits(int count, unsigned seed) const {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> share;
    std::vector<SeenHit> result;
    for (int i = 0; i < count; ++i) {
      glm::vec3 place(0.0f), normal(0.0f);
      for (int axis = 0; axis < 3; ++axis) place[axis] = share(engine) * box.upper[axis];
      normal[i % 3] = i % 2 == 0 ? 1.0f : -1.0f;
      place[i % 3] = i % 2 == 0 ? 0.0f : box.upper[i % 3];
      result.push_back({{place, normal, normal, 1.0f, static_cast<std::uint32_t>(i % 5 % 3)},
                        glm::normalize(0.5f * box.upper - place)});
    }
    return result;
  }
};

GridPlan planned_and_measured(const LitBox& scene, double tolerance, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  Options options = scene.options;
  options.tolerance = tolerance;
  const auto lighting = make_planned_lighting(scene.lights, options.bands);
  GridPlan plan = plan_grid(*lighting, scene.lights, scene.hits(3000, 1), scene.reflectors, scene.box, options);
  const PlannedField made = lighting->field(scene.box, plan.choice);
  measure(plan, *lighting, *made.field, scene.hits(5000, 2), scene.reflectors, 100000);
  return plan;
}

}  // namespace

TEST_CASE("tolerance: the near and the far part of a light add up to it, and their slopes are their derivatives") {
  const zonal::SphereLight<double> light{{0, 0, 0}, 0.3};
  const auto profile_of = [&](const auto& part, double distance) {
    return part.template profile<5>(zonal::Sight<double>{{1, 0, 0}, distance, 1 / distance});
  };
  const FarSphere<double> far{light.center, light.radius, 0.8, 1 / 1.5};
  const NearSphere<double> near{light.center, light.radius, 0.8, 1 / 1.5};
  for (double distance = 0.45; distance < 3.0; distance += 0.05) {
    const auto whole = profile_of(light, distance), of_far = profile_of(far, distance),
               of_near = profile_of(near, distance);
    const double step = 1e-5;
    const auto before = profile_of(far, distance - step), after = profile_of(far, distance + step);
    for (int l = 0; l < 5; ++l) {
      CAPTURE(distance, l);
      CHECK(std::abs(of_far.value[l] + of_near.value[l] - whole.value[l]) <= 1e-14);
      CHECK(std::abs(of_far.slope[l] + of_near.slope[l] - whole.slope[l]) <= 1e-13);
      CHECK(std::abs((after.value[l] - before.value[l]) / (2 * step) - of_far.slope[l]) <= 1e-7);
    }
    CHECK((distance > 0.8 || of_far.value[0] == 0.0));
    CHECK((distance < 2.3 || of_near.value[0] == 0.0));
  }
  const auto everywhere = part_of<FarSphere>(zonal::SphereLight<float>{{0, 0, 0}, 0.3f}, {});
  const zonal::Sight<float> sight{{1, 0, 0}, 0.4f, 2.5f};
  CHECK(everywhere.profile<3>(sight).value[2] == zonal::SphereLight<float>{{0, 0, 0}, 0.3f}.profile<3>(sight).value[2]);
  CHECK(everywhere.profile<3>(sight).slope[2] == zonal::SphereLight<float>{{0, 0, 0}, 0.3f}.profile<3>(sight).slope[2]);
}

TEST_CASE("tolerance: a grid with near lights one by one is nearer the truth, the farther these reach") {
  const LitBox scene(9, 20, 5);
  const auto lighting = make_planned_lighting(scene.lights, 5);
  const std::vector<SeenHit> hits = scene.hits(2000, 3);
  double before = std::numeric_limits<double>::infinity();
  for (const float reach : {0.0f, 0.8f, 1.6f, 3.2f}) {
    GridPlan plan;
    plan.choice = {5, zonal::Interpolation::hermite, {9, 7, 11}, {0.2f * reach, reach}};
    const PlannedField made = lighting->field(scene.box, plan.choice);
    measure(plan, *lighting, *made.field, hits, scene.reflectors, 1);
    CAPTURE(reach, plan.measured_error, before);
    CHECK(plan.measured_error < 0.6 * before);
    before = plan.measured_error;
  }
  CHECK(before < 0.002);
}

TEST_CASE("tolerance: what is measured is within it and near what was predicted, and no thread changes the choice") {
  for (const int bands : {3, 5}) {
    for (const auto& [near_walls, others] : {std::pair(0, 300), {9, 100}, {3, 5}}) {
      const LitBox scene(near_walls, others, bands);
      for (const double tolerance : {0.1, 0.03, 0.01}) {
        const GridPlan one = planned_and_measured(scene, tolerance, 1), two = planned_and_measured(scene, tolerance, 2);
        CAPTURE(bands, near_walls, others, tolerance, one.choice.bands, one.choice.resolution.x, one.choice.near.to);
        CAPTURE(one.predicted_error, one.measured_error);
        CHECK(one.measured_error <= tolerance);
        CHECK(one.predicted_error <= 5.0 * one.measured_error);
        CHECK(one.measured_error <= 5.0 * one.predicted_error);
        CHECK(one.measured_error == two.measured_error);
        CHECK(one.choice.resolution == two.choice.resolution);
        CHECK(one.choice.near.to == two.choice.near.to);
      }
    }
  }
}

TEST_CASE("tolerance: what no grid reaches has none, and more tolerance is no more work") {
  const GridPlan exact = planned_and_measured(LitBox(3, 5, 5), 1e-7, 2);
  CHECK(exact.choice.bands == 0);
  CHECK(exact.measured_error == 0.0);
  const LitBox scene(0, 300, 5);
  int before = std::numeric_limits<int>::max();
  for (const double tolerance : {0.01, 0.03, 0.1, 0.3}) {
    const GridChoice choice = planned_and_measured(scene, tolerance, 2).choice;
    const int numbers = choice.resolution.x * choice.resolution.y * choice.resolution.z * choice.bands * choice.bands;
    CAPTURE(tolerance, numbers, before);
    CHECK(choice.bands > 0);
    CHECK(numbers <= before);
    before = numbers;
  }
}
