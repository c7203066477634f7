// Light probes against what mirrors, lamps and a white sphere must give.
#include "field-capture/positions.hpp"
#include "field-capture/sequence.hpp"
#include "field-capture/truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <tbb/global_control.h>
#include <zonal/basis/evaluate.hpp>

#include "catch.hpp"
#include "field-capture/mirror_ball.hpp"
#include "files.hpp"
#include "shared/field_setup.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"

namespace {

using namespace example;
using namespace example::field_capture;

constexpr double pi = 3.14159265358979323846;

double uniform(Pcg32& random) { return static_cast<double>(random.uniform()); }

glm::dvec3 sphere_point(Pcg32& random) {
  const double z = 1.0 - 2.0 * uniform(random), phi = 2.0 * pi * uniform(random), s = std::sqrt(1.0 - z * z);
  return {s * std::cos(phi), s * std::sin(phi), z};
}

/// Nothing but a black triangle far away.
Scene empty_scene() {
  Scene scene;
  scene.materials = {{"black", zonal::Brdf{}}};
  scene.mesh.positions = {{90, 90, 90}, {91, 90, 90}, {90, 91, 90}};
  scene.mesh.normals.assign(3, {0, 0, 1});
  scene.mesh.triangles = {{0, 1, 2}};
  scene.mesh.triangle_materials = scene.mesh.triangle_meshes = {0};
  return scene;
}

/// visit(direction in the scene, radiance, solid angle) of all texels.
template <class Visit>
void for_each_texel(const Image& picture, const ProbeCamera& camera, const Visit& visit) {
  const glm::dquat turn(picture_orientation());
  zonal::visit_mapping(camera.mapping, [&](auto tag) {
    const typename decltype(tag)::Type mapping(camera.width, camera.height);
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        if (!mapping.has_direction(column, row)) continue;
        const auto d = mapping.direction(column + 0.5, row + 0.5);
        visit(turn * glm::dvec3(d[0], d[1], d[2]), glm::dvec3(picture.at(column, row)),
              mapping.solid_angle(column, row));
      }
    }
  });
}

/// The integral of radiance, and of radiance times direction.
struct Moments {
  double total = 0.0;
  glm::dvec3 vector{0.0};
};
Moments green_moments(const Image& picture, const ProbeCamera& camera) {
  Moments moments;
  for_each_texel(picture, camera, [&](const glm::dvec3& direction, const glm::dvec3& radiance, double solid_angle) {
    moments.total += radiance.g * solid_angle;
    moments.vector += radiance.g * solid_angle * direction;
  });
  return moments;
}

Options small_options() {
  Options options;
  options.probes = 8;
  options.layout = Layout::grid;
  options.side = 16;
  options.samples = 1;
  options.bounces = 1;
  options.sphere_radius = 0.05f;
  options.quiet = true;
  return options;
}

/// A folder that is not there at the beginning, nor at the end.
struct Folder {
  Folder() { std::filesystem::remove_all(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path = std::filesystem::temp_directory_path() / "zonal_field_capture_test";
};

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("a mirror sphere's ray starts at R n, and n reflects the eye's ray into it") {
  Pcg32 random(1);
  const zonal::MirrorSphere mapping(64, 64);
  const MirrorBall ball{{1.0, 0.0, 0.0}, 0.05};
  for (int i = 0; i < 1000; ++i) {
    const double column = 64.0 * uniform(random), row = 64.0 * uniform(random);
    const auto d = mapping.direction(column, row);
    const glm::dvec3 direction(d[0], d[1], d[2]);
    if (direction == glm::dvec3(0.0)) continue;
    const double p = column / 32.0 - 1.0, q = 1.0 - row / 32.0;
    const glm::dvec3 normal(-std::sqrt(1.0 - p * p - q * q), -p, q);
    CAPTURE(column, row);
    CHECK(glm::distance(ball.start(direction), 0.05 * normal) < 1e-9);
    CHECK(glm::distance(glm::reflect(glm::dvec3(1, 0, 0), normal), direction) < 1e-9);
  }
}

TEST_CASE("where a mirror sphere shows a point, its ray meets it, and areas are what differences say") {
  Pcg32 random(2);
  const MirrorBall ball{{1.0, 0.0, 0.0}, 0.05};
  const double step = 1e-5;
  int seen = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 towards = sphere_point(random);
    const glm::dvec3 point = (0.3 + 4.0 * uniform(random)) * towards;
    if (towards.x > 0.99) continue;
    const auto view = ball.view(point);
    CAPTURE(point.x, point.y, point.z);
    REQUIRE(view);
    const glm::dvec3 way = point - view->start;
    CHECK(glm::distance(view->start, ball.start(view->direction)) < 1e-9);
    CHECK(glm::length(glm::cross(way, view->direction)) < 1e-9);
    // Places on the disc of the picture, of points moved across the ray; on it, d omega = 4 dA.
    const glm::dvec3 u = glm::normalize(glm::cross(view->direction, glm::dvec3(0.36, 0.48, 0.8)));
    const glm::dvec3 v = glm::cross(view->direction, u);
    const auto place = [&](const glm::dvec3& offset) {
      const glm::dvec3 normal = ball.view(point + offset)->start / ball.radius;
      return glm::dvec2(-normal.y, normal.z);
    };
    const glm::dvec2 along_u = (place(step * u) - place(-step * u)) / (2.0 * step);
    const glm::dvec2 along_v = (place(step * v) - place(-step * v)) / (2.0 * step);
    const double per_area = 4.0 * std::abs(along_u.x * along_v.y - along_u.y * along_v.x);
    const double squared_distance = glm::dot(way, way);
    CHECK(std::abs(view->stretch - per_area * squared_distance) < 1e-5 * view->stretch);
    ++seen;
  }
  CHECK(seen > 450);
}

TEST_CASE("straight behind a mirror sphere a point is not seen") {
  const MirrorBall ball{{1.0, 0.0, 0.0}, 0.05};
  CHECK_FALSE(ball.view({2.0, 0.0, 0.0}));
  CHECK_FALSE(ball.view({2.0, 0.001, 0.0}));
}

TEST_CASE("a small lamp's texels hold its radiance times its solid angle") {
  const Scene scene = empty_scene();
  const RayCaster caster(scene);
  const glm::vec3 lamp(0.3f, 1.7f, -0.6f), probe(0.1f, 0.2f, 0.3f);
  const double radius = 0.01, radiance = 1e4;
  const IncidentRadiance light(
      scene, caster,
      {Emitter::projector(lamp, probe, float(radius), Emitter::Beam::even, 0.0f, glm::vec3(glm::dvec3(radiance)))}, 0);
  const double distance = glm::distance(glm::dvec3(lamp), glm::dvec3(probe));
  const double solid_angle = 2.0 * pi * (1.0 - distance / std::hypot(distance, radius));
  const glm::dvec3 towards = glm::normalize(glm::dvec3(lamp - probe));
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const ProbeCamera camera = ProbeCamera::of_side(static_cast<zonal::Mapping>(i), 64);
    const Image picture = capture_probe(camera, light, probe, 1, 1);
    const Moments moments = green_moments(picture, camera);
    CAPTURE(zonal::mapping_name(camera.mapping));
    CHECK(std::abs(moments.total / (radiance * solid_angle) - 1.0) < 1e-3);
    // In the texel where it is.
    CHECK(glm::dot(glm::normalize(moments.vector), towards) > 0.998);
  }
}

TEST_CASE("a rectangle's texels hold its radiance, and its outline") {
  const Scene scene = empty_scene();
  const RayCaster caster(scene);
  Emitter panel;
  panel.centre = {0.0f, 2.0f, 0.0f};
  panel.radiance = glm::vec3(3.0f);
  const IncidentRadiance light(scene, caster, {panel}, 0);
  const ProbeCamera camera = ProbeCamera::of_side(zonal::Mapping::octahedral, 64);
  const Moments moments = green_moments(capture_probe(camera, light, glm::vec3(0.0f), 64, 1), camera);
  // A rectangle of 2a x 2b at distance d: 4 asin(ab / sqrt((a^2 + d^2)(b^2 + d^2))).
  const double solid_angle = 4.0 * std::asin(0.25 / (0.25 + 4.0));
  CHECK(std::abs(moments.total / (3.0 * solid_angle) - 1.0) < 5e-3);
  CHECK(glm::normalize(moments.vector).y > 0.9999);
}

TEST_CASE("in a white sphere a probe sees what the lamp in its middle sends to it, and half a bounce more all around") {
  const Scene scene = make_furnace();  // of radius 2 and albedo 0.8
  const RayCaster caster(scene);
  const double lamp_radius = 0.02, radiance = 1000.0;
  const glm::vec3 at(0.4f, 0.3f, 0.5f);
  const IncidentRadiance light(scene, caster,
                               {Emitter::projector(glm::vec3(0.0f), {0.3f, -1.0f, 0.2f}, float(lamp_radius),
                                                   Emitter::Beam::even, 0.0f, glm::vec3(radiance))},
                               1);
  const glm::dvec3 axis(light.emitters()[0].normal());
  const double area = pi * lamp_radius * lamp_radius, albedo = 0.8, squared_radius = 4.0;
  const double again = albedo / pi * albedo * pi * radiance * area / (4.0 * pi * squared_radius);
  const ProbeCamera camera = ProbeCamera::of_side(zonal::Mapping::equirectangular, 64);
  const Image picture = capture_probe(camera, light, at, 16, 3);
  double worst = 0.0, sum = 0.0, expected_sum = 0.0;
  for_each_texel(picture, camera, [&](const glm::dvec3& direction, const glm::dvec3& seen, double solid_angle) {
    // Where the ray meets the sphere.
    const glm::dvec3 origin(at);
    const double b = glm::dot(origin, direction);
    const double t = -b + std::sqrt(b * b + squared_radius - glm::dot(origin, origin));
    const double cosine = std::max(glm::dot(glm::normalize(origin + t * direction), axis), 0.0);
    const double expected = albedo / pi * radiance * area * cosine / squared_radius + again;
    worst = std::max(worst, std::abs(seen.g - expected));
    sum += solid_angle * seen.g;
    expected_sum += solid_angle * expected;
  });
  CAPTURE(worst, sum, expected_sum, again);
  CHECK(std::abs(sum / expected_sum - 1.0) < 3e-3);
  CHECK(worst < 1.5 * again);  // the noise of 16 paths of one bounce more
}

TEST_CASE("a mirror sphere's texels show what is along rays from its surface") {
  const Scene scene = make_furnace();  // of radius 2 and albedo 0.8
  const RayCaster caster(scene);
  const double lamp_radius = 0.02, radiance = 1000.0;
  const glm::vec3 at(0.4f, 0.3f, 0.5f);
  const IncidentRadiance light(scene, caster,
                               {Emitter::projector(glm::vec3(0.0f), {0.3f, -1.0f, 0.2f}, float(lamp_radius),
                                                   Emitter::Beam::even, 0.0f, glm::vec3(glm::dvec3(radiance)))},
                               0);
  const glm::dvec3 axis(light.emitters()[0].normal());
  ProbeCamera camera = ProbeCamera::of_side(zonal::Mapping::mirror_sphere, 64);
  camera.sphere_radius = 0.3;
  const Image picture = capture_probe(camera, light, at, 16, 3);
  const glm::dvec3 forward = glm::dquat(picture_orientation()) * glm::dvec3(1.0, 0.0, 0.0);
  const double brightest = 0.8 * radiance * lamp_radius * lamp_radius / 4.0;
  double worst = 0.0;
  for_each_texel(picture, camera, [&](const glm::dvec3& direction, const glm::dvec3& seen, double) {
    if (glm::dot(direction, forward) > 0.9) return;  // a texel there is many directions
    const glm::dvec3 origin = glm::dvec3(at) + 0.3 * glm::normalize(direction - forward);
    const double b = glm::dot(origin, direction);
    const double t = -b + std::sqrt(b * b + 4.0 - glm::dot(origin, origin));
    const double cosine = std::max(glm::dot(glm::normalize(origin + t * direction), axis), 0.0);
    worst = std::max(worst, std::abs(seen.g - brightest * cosine));
  });
  CHECK(worst < 0.02 * brightest);
}

TEST_CASE("the true coefficients are those of the picture from the same place") {
  Scene scene = make_atrium(AtriumFinish::diffuse);
  const Bounds box = field_box(scene, std::nullopt);
  std::vector<Emitter> emitters = set_up_field(FieldSetup::projector, box, scene);
  const RayCaster caster(scene);
  const IncidentRadiance light(scene, caster, std::move(emitters), 1);
  const glm::vec3 place = box.centre() + glm::vec3(0.15f, 0.1f, 0.15f);
  const Truth truth = true_coefficients(light, place, 1 << 15, 5);
  for (const zonal::Mapping mapping : {zonal::Mapping::mirror_sphere, zonal::Mapping::horizontal_faces}) {
    const ProbeCamera camera = ProbeCamera::of_side(mapping, 256);
    Truth of_picture{};
    for_each_texel(capture_probe(camera, light, place, 4, 6), camera,
                   [&](const glm::dvec3& direction, const glm::dvec3& radiance, double solid_angle) {
                     const auto basis = zonal::evaluate<most_truth_bands>(direction);
                     for (int i = 0; i < 81; ++i) of_picture[i] += radiance * solid_angle * basis[i];
                   });
    for (int i = 0; i < 16; ++i) {
      CAPTURE(zonal::mapping_name(mapping), i, truth[i].r, of_picture[i].r, truth[i].b, of_picture[i].b);
      for (int c = 0; c < 3; ++c) CHECK(std::abs(truth[i][c] - of_picture[i][c]) < 0.01 * truth[0][c]);
    }
  }
}

TEST_CASE("the board blocks the red spotlight for half of the volume, and nothing else does") {
  Scene scene = make_atrium(AtriumFinish::diffuse);
  const Bounds box = field_box(scene, std::nullopt);
  const std::vector<Emitter> emitters = set_up_field(FieldSetup::spots, box, scene);
  const RayCaster caster(scene);
  const IncidentRadiance light(scene, caster, emitters, 0);
  Pcg32 random(7);
  int lit = 0, in_cone = 0;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    const glm::vec3 place = box.lower + glm::vec3(glm::dvec3(x, y, z)) * (box.upper - box.lower);
    for (const int lamp : {0, 1}) {
      const Emitter& emitter = emitters[static_cast<std::size_t>(lamp)];
      const auto arrival = light.arrival(emitter, place, glm::vec2(0.5f), 1);
      if (arrival.irradiance == glm::vec3(0.0f)) continue;
      const bool visible = light.visible(place, arrival.point);
      if (lamp == 0) lit += visible ? 1 : 0;
      if (lamp == 0) continue;
      CHECK(visible);
      ++in_cone;
    }
  }
  CAPTURE(lit, in_cone);
  CHECK(std::abs(lit / double(count) - 0.5) < 0.03);
  // A cone of 0.075 rad and 3.57 m to the middle of a box of a metre.
  CHECK(in_cone > count / 20);
  CHECK(in_cone < count / 2);
}

TEST_CASE("layouts: as many as asked for, in the box, and neighbours near each other") {
  const Bounds box{{1.0f, 2.0f, 3.0f}, {2.0f, 4.0f, 4.0f}};
  for (const Layout layout : {Layout::grid, Layout::planes, Layout::random}) {
    Options options = small_options();
    options.layout = layout;
    options.probes = 1000;
    const std::vector<glm::vec3> positions = probe_positions(options, box);
    CAPTURE(static_cast<int>(layout), positions.size());
    CHECK(std::abs(double(positions.size()) - 1000.0) < 60.0);
    float furthest = 0.0f;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(positions[i][axis] >= box.lower[axis]);
        CHECK(positions[i][axis] <= box.upper[axis]);
      }
      if (i > 0) furthest = std::max(furthest, glm::distance(positions[i], positions[i - 1]));
    }
    CHECK(furthest < (layout == Layout::planes ? 1.6f : 0.45f));  // from plane to plane it is far
  }
}

TEST_CASE("layouts: about as many as asked for in boxes flat and long, of any size") {
  for (const glm::vec3& sides : {glm::vec3(1, 1, 1), glm::vec3(10, 10, 0.001F), glm::vec3(1e8F, 1e8F, 1e-8F),
                                 glm::vec3(1e-8F, 1e8F, 1e-8F), glm::vec3(1e-30F), glm::vec3(1e30F, 1e-30F, 1)}) {
    for (const Layout layout : {Layout::grid, Layout::planes, Layout::random}) {
      for (const int probes : {1, 30, 1000}) {
        Options options;
        options.layout = layout;
        options.probes = probes;
        const auto count = probe_positions(options, {-0.5F * sides, 0.5F * sides}).size();
        CAPTURE(sides.x, sides.y, sides.z, int(layout), probes, count);
        CHECK((std::max(probes / 3, 1) <= int(count) && int(count) <= 3 * probes + 2));
      }
    }
  }
}

TEST_CASE("positions of a file: up to 1e8, three a line, and what is none is told with its line") {
  const file_test::Folder folder;
  const auto error_of = [&](const std::string& text) -> std::string {
    file_test::write(folder.path / "p.txt", text);
    try {
      read_positions(folder.path / "p.txt");
    } catch (const InputError& failure) {
      return failure.what();
    }
    return "";
  };
  CHECK(error_of("# two\n1 2 3\n-1e8 1e8 0.5\n").empty());
  CHECK(file_test::contains(error_of("1 2 3\n1 2\n"), "p.txt: line 2 is no position x y z"));
  CHECK(file_test::contains(error_of("1 2 3\n\n1 2 1e300\n"), "p.txt: line 3 is beyond 1e8"));
  CHECK(file_test::contains(error_of("nan 2 3\n"), "p.txt: line 1 is no position x y z"));
  CHECK(file_test::contains(error_of("# nothing\n"), "p.txt: has no positions"));
}

TEST_CASE("a sequence: the same bytes for any number of threads, and what is there and whole is kept") {
  Scene scene = make_atrium(AtriumFinish::diffuse);
  const Options options = small_options();
  const Bounds box = field_box(scene, std::nullopt);
  std::vector<Emitter> emitters = set_up_field(options.setup, box, scene);
  const RayCaster caster(scene);
  const IncidentRadiance light(scene, caster, std::move(emitters), options.bounces);
  const std::vector<glm::vec3> positions = probe_positions(options, box);
  REQUIRE(positions.size() == 8);
  const Folder folder;
  const auto run = [&](const Options& with) { return capture_sequence(folder.path, positions, with, box, light); };
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(run(options).kept == 0);
  }
  std::vector<std::string> pictures;
  const auto picture = [&](int i) { return folder.path / ("probe-0000" + std::to_string(i) + ".exr"); };
  for (int i = 0; i < 8; ++i) pictures.push_back(bytes_of(picture(i)));

  const zonal::ProbeSequence sequence = zonal::read_sequence(folder.path / "sequence.txt");
  REQUIRE(sequence.probes.size() == 8);
  CHECK(sequence.mapping == zonal::Mapping::mirror_sphere);
  CHECK(sequence.sphere_radius == 0.05f);
  CHECK(std::abs(glm::degrees(sequence.dead_angle) - 4.2f) < 1e-5f);
  CHECK(std::abs(glm::dot(sequence.orientation, picture_orientation())) > 0.999999f);
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(sequence.probes[i].position == positions[i]);
    CHECK(read_exr(sequence.probes[i].picture).width == 16);
  }

  std::filesystem::remove(picture(2));
  std::filesystem::resize_file(picture(5), 300);
  std::ofstream(picture(6), std::ios::binary) << exr_bytes(Image(4, 4));
  CHECK(run(options).kept == 5);
  for (int i = 0; i < 8; ++i) CHECK(bytes_of(picture(i)) == pictures[static_cast<std::size_t>(i)]);

  Options others = options;
  others.seed = 2;
  CHECK_THROWS_AS(run(others), InputError);
}

}  // namespace
