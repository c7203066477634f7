#include "time_budget.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "shared/interrupt.hpp"
#include "shared/primary_hits.hpp"

namespace example::hvl_render {
namespace {

constexpr int most_lights = 1000000;  // as of --lights

/// Some primary rays spread over the picture: what they hit, and what share of all rays they are.
struct Probe {
  std::vector<Hit> hits;
  double share;
};

Probe probe_picture(const Scene& scene, const RayCaster& caster, const Options& options) {
  constexpr int wanted = 4096;
  const double pixels = static_cast<double>(options.width) * static_cast<double>(options.height);
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / wanted)));
  const CameraRays rays(scene.camera, options.width, options.height);
  Probe probe{{}, 0.0};
  int traced = 0;
  for (int y = step / 2; y < options.height; y += step) {
    for (int x = step / 2; x < options.width; x += step, ++traced) {
      const glm::vec3 direction = rays.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      if (const auto hit = caster.closest(scene.camera.position, direction)) probe.hits.push_back(*hit);
    }
  }
  probe.share = traced / (pixels * options.antialias * options.antialias);
  return probe;
}

/// Seconds for the whole picture with so many lights: shooting them, and gathering at the probe's hits, each the least
/// of some runs.
double measure(const Scene& scene, const RayCaster& caster, const MaterialTables& materials, const Probe& probe,
               Options options, int lights) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  options.lights = lights;
  double shooting = std::numeric_limits<double>::infinity(), gathering = shooting, spent = 0.0;
  for (int run = 0; run < 5 && (run < 2 || spent < 0.05); ++run) {
    throw_if_interrupted();
    auto start = Clock::now();
    const VirtualLightMap map = shoot_virtual_lights(scene, caster, materials, options);
    const auto gatherer = make_gatherer({scene, caster, materials, map, options});
    shooting = std::min(shooting, seconds(start));

    start = Clock::now();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probe.hits.size(), 64), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const glm::vec3 radiance = gatherer->indirect_radiance(probe.hits[i], towards_camera(scene, probe.hits[i]), i);
        static_cast<void>(radiance);
      }
    });
    gathering = std::min(gathering, seconds(start));
    spent += seconds(start);
  }
  return shooting + gathering / probe.share;
}

int square_at_most(double count) {
  const double side = std::floor(std::sqrt(std::clamp(count, 1.0, static_cast<double>(most_lights))));
  return static_cast<int>(side * side);
}

}  // namespace

int lights_within_budget(const Scene& scene, const RayCaster& caster, const MaterialTables& materials,
                         const Options& options) {
  const Probe probe = probe_picture(scene, caster, options);
  const auto time = [&](int lights) { return measure(scene, caster, materials, probe, options, lights); };
  constexpr int few = 64, more = 256;
  const double budget = *options.time_budget, at_few = time(few), at_more = time(more);
  const double per_light = std::max((at_more - at_few) / (more - few), 1e-3 * at_more / more);
  const double fixed = std::max(0.0, at_few - few * per_light);
  const int first = square_at_most((budget - fixed) / per_light);
  if (first <= few) return first;
  // Once more where it will be: caches fill, and the materials lit change.
  const double at_first = time(first);
  return square_at_most(first * (budget - fixed) / std::max(at_first - fixed, 1e-9));
}

}  // namespace example::hvl_render
