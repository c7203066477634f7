// The sets of lights against what a closed sphere, a panel and a picture must give, and the filters where they must not
// matter.
#include "igi-render/light_sets.hpp"
#include "igi-render/option_names.hpp"
#include "igi-render/shaded_picture.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"

namespace {

using namespace example;
using namespace example::igi_render;

constexpr float pi = 3.14159265f;

/// Irradiance at a place with this normal, nothing in the way, from all sets, of which each is a whole estimate.
glm::dvec3 irradiance(const std::vector<zonal::LightSet>& sets, const glm::vec3& position, const glm::vec3& normal,
                      float least_distance = 1e-3f) {
  glm::dvec3 sum(0.0);
  for (const zonal::LightSet& set : sets) {
    zonal::for_each_arrival(set, position, normal, least_distance, {}, [&](const auto& arrival) {
      for (int lane = 0; lane < zonal::LightSet::Lanes::width; ++lane) {
        const auto component = [&](const auto& v, int i) { return static_cast<double>(v[i][lane]); };
        const glm::dvec3 w(component(arrival.direction, 0), component(arrival.direction, 1),
                           component(arrival.direction, 2));
        const double cosine = std::max(glm::dot(w, glm::dvec3(normal)), 0.0);
        for (int c = 0; c < 3; ++c) sum[c] += component(arrival.irradiance, c) * cosine;
      }
    });
  }
  return sum / static_cast<double>(sets.size());
}

void check_close(const glm::dvec3& got, const glm::dvec3& expected, double share) {
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, got[c], expected[c]);
    CHECK(std::abs(got[c] - expected[c]) <= share * expected[c]);
  }
}

Options options_of(Lighting lighting, int samples, int bounces) {
  Options options;
  options.lighting = lighting;
  options.samples = samples;
  options.bounces = bounces;
  options.width = 40;
  options.height = 32;
  options.quiet = true;
  return options;
}

/// A picture on disk as long as this lives.
struct ProbeFile {
  explicit ProbeFile(const Image& picture) { std::ofstream(path, std::ios::binary) << exr_bytes(picture); }
  ~ProbeFile() { std::filesystem::remove(path); }
  std::string path = (std::filesystem::temp_directory_path() / "zonal_igi_render_test.exr").string();
};

/// What all filters make of a scene, and the reference.
struct Run {
  Run(const Scene& scene, const Options& options) : caster(scene), progress(false) {
    const ScreenScene screen = make_screen(scene, caster, options, nullptr, times, progress);
    for (const auto& [name, filter] : filter_names) passes.push_back(filtered_pass(screen, filter, progress));
    reference = reference_pass(screen, progress);
  }
  const Image& of(Filter filter) const { return passes[static_cast<std::size_t>(filter)].picture; }

  RayCaster caster;
  Progress progress;
  StageTimes times;
  std::vector<Pass> passes;
  Reference reference;
};

/// The root of the mean square of differences, relative to the mean.
double difference(const Image& a, const Image& b) {
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
    squares += glm::dot(d, d);
    sum += glm::dot(glm::dvec3(b.pixels[i]), glm::dvec3(1.0));
  }
  const double count = 3.0 * static_cast<double>(a.pixels.size());
  return std::sqrt(squares / count) / (sum / count);
}

}  // namespace

TEST_CASE("in a white sphere each bounce adds the same irradiance everywhere") {
  const Scene scene = make_furnace();
  const RayCaster caster(scene);
  constexpr float radius = 2.0f, albedo = 0.8f;
  const double power = 6.0 * static_cast<double>(scene.light.effective_solid_angle());
  for (int bounces = 1; bounces <= 3; ++bounces) {
    const auto direct = make_light_sets(scene, caster, options_of(Lighting::spot, 64, 0), nullptr);
    const auto all = make_light_sets(scene, caster, options_of(Lighting::spot, 64, bounces), nullptr);
    double expected = 0.0;
    for (int bounce = 1; bounce <= bounces; ++bounce) {
      expected += std::pow(static_cast<double>(albedo), bounce) * power / (4.0 * double(pi) * double(radius * radius));
    }
    for (const glm::vec3 side : {glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0.6f, -0.8f, 0)}) {
      CAPTURE(bounces, side.x, side.y, side.z);
      const glm::dvec3 light = irradiance(all, radius * side, -side) - irradiance(direct, radius * side, -side);
      // The cone's fading edge, by 1024 paths. The sphere is of flat pieces.
      check_close(light, glm::dvec3(expected), 5e-3);
    }
  }
}

TEST_CASE("three points and a panel send paths as strong as they are") {
  Scene scene = make_furnace();
  // From inside a sphere all light of the sources lands on it, and then is the same everywhere.
  const RayCaster caster(scene);
  for (const Lighting lighting : {Lighting::three, Lighting::area}) {
    const Options options = options_of(lighting, 64, 1);
    const auto sets = make_light_sets(scene, caster, options, nullptr);
    Options without = options;
    without.bounces = 0;
    const auto direct = make_light_sets(scene, caster, without, nullptr);
    // The irradiance that falls on the sphere first, over all of it.
    glm::dvec3 landed(0.0);
    constexpr int rings = 60, spokes = 60;
    for (int i = 0; i < rings; ++i) {
      const float z = -1.0f + 2.0f * (float(i) + 0.5f) / rings, r = std::sqrt(1.0f - z * z);
      for (int j = 0; j < spokes; ++j) {
        const float phi = 2.0f * pi * (float(j) + 0.5f) / spokes;
        const glm::vec3 side(r * std::cos(phi), r * std::sin(phi), z);
        landed += irradiance(direct, 2.0f * side, -side) / double(rings * spokes);
      }
    }
    const glm::vec3 side(0.0f, 0.28f, 0.96f);
    CAPTURE(name_of(lighting_names, lighting));
    const glm::dvec3 bounced = irradiance(sets, 2.0f * side, -side) - irradiance(direct, 2.0f * side, -side);
    check_close(bounced, 0.8 * landed, 0.02);
  }
}

TEST_CASE("a panel's samples are its light") {
  Scene scene = make_furnace();
  const RayCaster caster(scene);
  const auto sets = make_light_sets(scene, caster, options_of(Lighting::area, 32, 0), nullptr);
  // 1 m square in the plane y = 0, that shines upwards or downwards.
  for (const float y : {-1.5f, 1.5f}) {
    const glm::vec3 position(0.3f, y, 0.2f), normal(0.0f, y < 0.0f ? 1.0f : -1.0f, 0.0f);
    double expected = 0.0;
    constexpr int side = 200;
    for (int i = 0; i < side * side; ++i) {
      const glm::dvec3 at((i % side + 0.5) / side - 0.5, 0.0, (i / side + 0.5) / side - 0.5);
      const glm::dvec3 to = at - glm::dvec3(position);
      const double squared = glm::dot(to, to);
      expected += 6.0 * std::pow(std::abs(to.y), 2) / (squared * squared) / (side * side);
    }
    const glm::dvec3 got = irradiance(sets, position, normal);
    // It shines to one side.
    if (glm::length(got) > 0.0) check_close(got, glm::dvec3(expected), 5e-3);
  }
  const double both = irradiance(sets, {0, -1.5f, 0}, {0, 1, 0}).x + irradiance(sets, {0, 1.5f, 0}, {0, -1, 0}).x;
  CHECK(both > 0.0);
}

TEST_CASE("a picture's samples are its light, from where it is: up is y") {
  Image sky(64, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) sky.at(x, y) = y < 16 ? glm::vec3(0.5f, 1.0f, 2.0f) : glm::vec3(0.1f, 0.0f, 0.0f);
  }
  sky.at(10, 4) = glm::vec3(300.0f);
  const ProbeFile file(sky);
  const Probe probe(file.path);
  CHECK(probe.radiance({0.1f, 0.9f, 0.0f}).b == 2.0f);
  CHECK(probe.radiance({0.1f, -0.9f, 0.3f}).b == 0.0f);

  Scene scene = make_furnace();
  const RayCaster caster(scene);
  const auto sets = make_light_sets(scene, caster, options_of(Lighting::probe, 256, 0), &probe);
  for (const glm::vec3 normal : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)}) {
    glm::dvec3 expected(0.0);
    constexpr int rings = 512, spokes = 1024;  // whole texels
    for (int i = 0; i < rings; ++i) {
      const double polar = double(pi) * (i + 0.5) / rings;
      for (int j = 0; j < spokes; ++j) {
        const double phi = 2.0 * double(pi) * (j + 0.5) / spokes;
        const glm::dvec3 w(std::sin(polar) * std::cos(phi), std::cos(polar), std::sin(polar) * std::sin(phi));
        const double weight = std::sin(polar) * 2.0 * double(pi * pi) / (rings * spokes);
        expected += glm::dvec3(probe.radiance(glm::vec3(w))) * std::max(glm::dot(w, glm::dvec3(normal)), 0.0) * weight;
      }
    }
    CAPTURE(normal.x, normal.y, normal.z);
    check_close(irradiance(sets, glm::vec3(0.0f), normal) + 0.01, expected + 0.01, 0.03);
  }
  CHECK_THROWS_AS(Probe("nowhere.exr"), InputError);
}

TEST_CASE("seeds come nearer to each other as paths from a panel or a picture grow in number") {
  const Scene scene = make_atrium(AtriumFinish::courtyard);
  const RayCaster caster(scene);
  Image sky(64, 32);
  for (glm::vec3& texel : sky.pixels) texel = glm::vec3(0.2f);
  for (int y = 2; y < 8; ++y) sky.at(10, y) = glm::vec3(30.0f);
  const ProbeFile file(sky);
  const Probe probe(file.path);

  // What bounces to places in mid-air.
  const auto bounced = [&](Options options) {
    const auto all = make_light_sets(scene, caster, options, &probe);
    options.bounces = 0;
    const auto direct = make_light_sets(scene, caster, options, &probe);
    std::vector<double> light;
    for (const glm::vec3 offset : {glm::vec3(0), glm::vec3(0.7f, 0.3f, -0.5f), glm::vec3(-0.6f, -0.4f, 0.5f)}) {
      for (const glm::vec3 normal : {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)}) {
        const glm::vec3 place = bounds_of(scene.mesh).centre() + offset;
        light.push_back(irradiance(all, place, normal, 0.5f).g - irradiance(direct, place, normal, 0.5f).g);
      }
    }
    return light;
  };
  // Its standard deviation over seeds, relative to its mean, over all places.
  const auto deviation = [&](Lighting lighting, int side) {
    Options options = options_of(lighting, 4, 1);
    options.pattern = {side, side};
    std::vector<std::vector<double>> of_seeds;
    for (options.seed = 1; options.seed <= 16; ++options.seed) of_seeds.push_back(bounced(options));
    const double seeds = static_cast<double>(of_seeds.size()), places = static_cast<double>(of_seeds[0].size());
    double variance = 0.0;
    for (std::size_t place = 0; place < of_seeds[0].size(); ++place) {
      double sum = 0.0, squares = 0.0;
      for (const auto& light : of_seeds) sum += light[place], squares += light[place] * light[place];
      variance += (seeds * squares / (sum * sum) - 1.0) / places;
    }
    return std::sqrt(variance);
  };
  for (const Lighting lighting : {Lighting::area, Lighting::probe}) {
    const double few = deviation(lighting, 4), many = deviation(lighting, 16);
    CAPTURE(name_of(lighting_names, lighting), few, many);
    CHECK(many < 0.25 * few);  // what 16 times as many random paths come to
  }
}

TEST_CASE("with one set a filter changes nothing: reflected light is the reference, radiance its bands") {
  const Scene scene = make_atrium(AtriumFinish::bumped_glossy);
  Options options = options_of(Lighting::area, 4, 1);
  options.pattern = {1, 1};
  const Run run(scene, options);
  CHECK(difference(run.of(Filter::irradiance), run.reference.exact.picture) < 1e-6);
  CHECK(difference(run.of(Filter::radiance), run.reference.truncated.picture) < 1e-6);
  CHECK(difference(run.of(Filter::none), run.reference.truncated.picture) < 1e-6);
  CHECK(difference(run.of(Filter::first_degree), run.reference.exact.picture) > 0.01);
}

TEST_CASE("on the bumped scene radiance is filtered better than reflected light, and both better than nothing") {
  const Scene scene = make_atrium(AtriumFinish::bumped);
  Options options = options_of(Lighting::area, 8, 1);
  options.width = 320;
  options.height = 256;
  const Run run(scene, options);
  // As it is seen: in linear light few pixels, each beside a virtual light, outweigh all others, and the ratio of
  // errors is anything from 0.6 to 1.2, as the seed has it.
  const auto seen = [&](Filter filter) {
    return compare(run.of(filter), run.reference.exact.picture, options.display).rmse;
  };
  const double radiance = seen(Filter::radiance), irradiance = seen(Filter::irradiance);
  CAPTURE(radiance, irradiance, seen(Filter::irradiance_strict), seen(Filter::none));
  CHECK(radiance < 0.6 * irradiance);
  CHECK(radiance < 0.65 * seen(Filter::irradiance_strict));
  CHECK(irradiance < 0.7 * seen(Filter::none));
  // Most of the unfiltered noise is in what a display cuts off.
  const auto light = [&](Filter filter) { return difference(run.of(filter), run.reference.exact.picture); };
  CAPTURE(light(Filter::irradiance), light(Filter::none));
  CHECK(light(Filter::irradiance) < 0.5 * light(Filter::none));
}

TEST_CASE("a window takes ringing off gloss, and leaves what is matte as it is") {
  for (const AtriumFinish finish : {AtriumFinish::bumped_glossy, AtriumFinish::bumped}) {
    const Scene scene = make_atrium(finish);
    Options options = options_of(Lighting::area, 8, 1);
    const bool is_glossy = finish == AtriumFinish::bumped_glossy;
    options.width = is_glossy ? 160 : 40;  // equal is equal, however small
    options.height = is_glossy ? 128 : 32;
    const auto error = [&](zonal::Window window) {
      options.window = window;
      const Run run(scene, options);
      return compare(run.of(Filter::radiance), run.reference.exact.picture, options.display).rmse;
    };
    const double without = error(zonal::Window::none), sinc = error(zonal::Window::sinc);
    CAPTURE(without, sinc);
    if (is_glossy) CHECK(sinc < 0.92 * without);
    if (!is_glossy) CHECK(sinc == without);
  }
}

TEST_CASE("sixteen bits change next to nothing") {
  const Scene scene = make_atrium(AtriumFinish::bumped);
  Options options = options_of(Lighting::three, 2, 1);
  const Run floats(scene, options);
  options.half = true;
  const Run halves(scene, options);
  for (const auto& [name, filter] : filter_names) {
    CAPTURE(name);
    CHECK(difference(halves.of(filter), floats.of(filter)) < 1e-3);
  }
}
