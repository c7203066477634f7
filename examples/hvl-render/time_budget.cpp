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

/// Some primary rays spread over the picture: what they hit, and what share of all rays they are.
struct Probe {
  std::vector<Hit> hits;
  double share;
};

Probe probe_picture(const Scene& scene, const RayCaster& caster, const Options& options) {
  const double pixels = static_cast<double>(options.width) * static_cast<double>(options.height);
  // Enough to speak for the picture, and of a small one a small part.
  const double wanted = std::clamp(pixels / 64.0, 64.0, 4096.0);
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

/// Seconds for the whole picture with so many lights: shooting them, and gathering at the probe's hits, as often as it
/// takes for a reliable mean.
double measure(const Scene& scene, const RayCaster& caster, const MaterialTables& materials, const Probe& probe,
               Options options, int lights) {
  constexpr double reliable_seconds = 0.1;
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  options.lights = lights;
  double shooting = 0.0, gathering = 0.0;
  int runs = 0;
  for (; runs == 0 || shooting + gathering < reliable_seconds; ++runs) {
    auto start = Clock::now();
    const VirtualLightMap map = shoot_virtual_lights(scene, caster, materials, options);
    const auto gatherer = make_gatherer({scene, caster, materials, map, options});
    shooting += seconds(start);

    start = Clock::now();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, probe.hits.size(), 16), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end() && !stop_requested(); ++i) {
        const glm::vec3 radiance = gatherer->indirect_radiance(probe.hits[i], towards_camera(scene, probe.hits[i]), i);
        static_cast<void>(radiance);
      }
    });
    gathering += seconds(start);
    throw_if_interrupted();
  }
  return (shooting + gathering / probe.share) / runs;
}

/// A square map, and how long it takes.
struct Trial {
  int side;
  double seconds;

  double lights() const { return static_cast<double>(side) * side; }
};

/// The side at which the straight line through two trials takes so long, `a` having the fewer lights.
double side_between(const Trial& a, const Trial& b, double seconds) {
  const double per_light = (b.seconds - a.seconds) / (b.lights() - a.lights());
  return std::sqrt(std::max(0.0, a.lights() + (seconds - a.seconds) / std::max(per_light, 1e-12)));
}

}  // namespace

int lights_within_budget(const Scene& scene, const RayCaster& caster, const MaterialTables& materials,
                         const Options& options) {
  const Probe probe = probe_picture(scene, caster, options);
  const double budget = *options.time_budget;
  const auto attempt = [&](int side) {
    return Trial{side, measure(scene, caster, materials, probe, options, side * side)};
  };
  attempt(1);  // not counted: it warms the caches
  Trial within = attempt(1);
  if (within.seconds > budget) return 1;
  Trial beyond{greatest_side(options) + 1, std::numeric_limits<double>::infinity()};
  // Up by leaps while the budget holds, then by what the two nearest trials say. Lights come in packets, and packets
  // by material, so that the line is straight only in the small.
  double next = 8.0;
  for (int round = 0; round < 12 && beyond.side - within.side > 1 && within.seconds < 0.97 * budget; ++round) {
    const Trial trial = attempt(std::clamp(static_cast<int>(next), within.side + 1, beyond.side - 1));
    const Trial before = within;
    (trial.seconds > budget ? beyond : within) = trial;
    next = std::isinf(beyond.seconds) ? std::min(side_between(before, within, budget), 4.0 * within.side)
                                      : side_between(within, beyond, budget);
  }
  return within.side * within.side;
}

}  // namespace example::hvl_render
