#include "grid_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "band_list.hpp"
#include "parallel.hpp"
#include "shared/primary_hits.hpp"
#include "shared/stage_times.hpp"

namespace example::grid_render {
namespace {

using zonal::Interpolation;

/// Vertices along the longest axis, and how far near lights reach, in cells.
constexpr std::array resolutions{3, 4, 6, 8, 11, 16, 22, 32};
constexpr std::array tried_reaches{0.0f, 1.5f, 3.0f, 5.0f};

/// Of the points one of so many, which tell what is hopeless.
constexpr std::size_t few = 48;

/// Cells about as long along all axes.
glm::ivec3 resolution_of(const Bounds& box, int longest) {
  const glm::vec3 size = box.upper - box.lower;
  const float cell = std::max({size.x, size.y, size.z}) / static_cast<float>(longest - 1);
  return glm::max(glm::ivec3(glm::ceil(size / cell - 1e-3f)) + 1, glm::ivec3(2));
}

float longest_side(const Bounds& box, const glm::ivec3& resolution) {
  const glm::vec3 cell = (box.upper - box.lower) / glm::vec3(resolution - 1);
  return std::max({cell.x, cell.y, cell.z});
}

struct Candidate {
  GridChoice choice;
  double cost, near_lights;
  int longest = 0;     // of the resolution
  float reach = 0.0f;  // in cells
};

/// Nanoseconds that a choice takes on one thread of 16 lanes (measured with 5 bands, AMD EPYC), of which the
/// proportions count: of a light at a vertex, of a look-up, and of lights at a point, with a packet's last lanes and
/// their sum.
double cost_of(const GridChoice& choice, double near_lights, std::size_t lights, double points, int bands) {
  const auto coefficients = [](int n) { return static_cast<double>(n * n); };
  const auto at_point = [&](double count) {
    return count > 0.0 ? 10.0 * coefficients(bands) + (count + 8.0) * (3.0 + 0.5 * coefficients(bands)) : 0.0;
  };
  if (choice.bands == 0) return points * at_point(static_cast<double>(lights));
  const bool is_hermite = choice.method == Interpolation::hermite;
  const double fill = is_hermite ? 4.0 + 0.9 * coefficients(choice.bands) : 2.0 + 0.3 * coefficients(choice.bands);
  const double look_up = (is_hermite ? 11.0 : 4.0) * coefficients(choice.bands);
  const glm::dvec3 size(choice.resolution);
  return size.x * size.y * size.z * static_cast<double>(lights) * fill + points * (look_up + at_point(near_lights));
}

double mean_near_lights(const std::vector<SeenHit>& hits, const SphereLights& lights, const NearRange& near) {
  if (near.is_empty()) return 0.0;
  std::size_t count = 0, points = 0;
  for (std::size_t i = 0; i < hits.size(); i += few, ++points) {
    for (const auto& light : lights) {
      count += glm::distance(hits[i].hit.position, light.light.center) < light.light.radius + near.to;
    }
  }
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(points, 1));
}

std::vector<Candidate> candidates(const SphereLights& lights, const std::vector<SeenHit>& hits, const Bounds& box,
                                  const Options& options) {
  const double points = static_cast<double>(options.width) * options.height * options.antialias * options.antialias;
  std::vector<Candidate> all;
  const auto cost = [&](const GridChoice& choice, double near_lights) {
    return cost_of(choice, near_lights, lights.size(), points, options.bands);
  };
  all.push_back({{}, cost({}, 0.0), static_cast<double>(lights.size())});
  for (const int longest : resolutions) {
    const glm::ivec3 resolution = resolution_of(box, longest);
    for (const float reach : tried_reaches) {
      const float to = reach * longest_side(box, resolution);
      const NearRange near{0.2f * to, to};
      const double near_lights = mean_near_lights(hits, lights, near);
      for (const int bands : AllBands::numbers) {
        if (bands > options.bands) continue;
        for (const Interpolation method : {Interpolation::trilinear, Interpolation::hermite}) {
          const GridChoice choice{bands, method, resolution, near};
          all.push_back({choice, cost(choice, near_lights), near_lights, longest, reach});
        }
      }
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return all;
}

/// What has been looked at: all ways of a grid's cells at once, at some points first.
class TriedGrids {
 public:
  TriedGrids(const PlannedLighting& lighting, const PlanPoints& points, const Bounds& box)
      : lighting_(lighting), points_(points), box_(box) {}

  /// Its error; or, where that is beyond the tolerance, one that says so.
  ErrorEstimate error(const Candidate& candidate, double tolerance) {
    const double hoped = hoped_for(candidate);
    if (hoped > tolerance) return {hoped, hoped};
    const ErrorEstimate at_few = look(candidate, few);
    return at_few.seen > tolerance ? at_few : look(candidate, 1);
  }
  std::size_t count() const { return count_; }

 private:
  struct Tried {
    int longest;
    float reach;
    std::size_t one_of;
    std::vector<GridWay> ways;

    ErrorEstimate error(const GridChoice& choice) const {
      const auto is_it = [&](const GridWay& way) { return way.bands == choice.bands && way.method == choice.method; };
      return std::find_if(ways.begin(), ways.end(), is_it)->error;
    }
  };

  /// No less than this by what coarser grids gave: errors fall as the square of the cell or its fourth power, and
  /// here half as fast again; the part that comes of fewer bands does not fall.
  double hoped_for(const Candidate& candidate) {
    double least = bands_error(candidate.choice.bands);
    const double power = candidate.choice.method == Interpolation::hermite ? 6.0 : 3.0;
    for (const Tried& tried : tried_) {
      if (tried.reach < candidate.reach || candidate.reach < tried.reach || tried.longest > candidate.longest) continue;
      const double finer = (candidate.longest - 1.0) / (tried.longest - 1.0);
      least = std::max(least, tried.error(candidate.choice).seen / std::pow(finer, power));
    }
    return least;
  }

  /// Of what has fewer bands and no grid.
  double bands_error(int bands) {
    for (const auto& [of, error] : bands_errors_) {
      if (of == bands) return error;
    }
    const std::vector<glm::vec3> radiance = lighting_.radiance(points_.hits, points_.reflectors, bands);
    const double error =
        estimate_error(points_, 1, [&](std::size_t i) { return glm::dvec3(radiance[i] - points_.radiance[i]); }).seen;
    bands_errors_.emplace_back(bands, error);
    return error;
  }

  ErrorEstimate look(const Candidate& candidate, std::size_t one_of) {
    for (const Tried& tried : tried_) {
      const bool is_it = tried.longest == candidate.longest && tried.one_of == one_of &&
                         !(tried.reach < candidate.reach || candidate.reach < tried.reach);
      if (is_it) return tried.error(candidate.choice);
    }
    const GridChoice& choice = candidate.choice;
    count_ += one_of > 1;
    tried_.push_back({candidate.longest, candidate.reach, one_of,
                      lighting_.errors(points_, one_of, box_, choice.resolution, choice.near)});
    return tried_.back().error(choice);
  }

  const PlannedLighting& lighting_;
  const PlanPoints& points_;
  const Bounds& box_;
  std::vector<Tried> tried_;
  std::size_t count_ = 0;
  std::vector<std::pair<int, double>> bands_errors_;
};

}  // namespace

GridPlan plan_grid(const PlannedLighting& lighting, const SphereLights& lights, std::vector<SeenHit> hits,
                   const std::vector<Reflector>& reflectors, const Bounds& box, const Options& options) {
  PlanPoints points{reflectors, std::move(hits), {}};
  points.radiance = lighting.radiance(points.hits, reflectors, options.bands);
  GridPlan plan;
  plan.predicted_at = points.hits.size();
  plan.light_bytes = lights.size() * sizeof(SphereLights::value_type);
  TriedGrids tried(lighting, points, box);
  for (const Candidate& candidate : candidates(lights, points.hits, box, options)) {
    throw_if_interrupted();
    plan.choice = candidate.choice;
    plan.near_lights = candidate.near_lights;
    const ErrorEstimate error =
        candidate.choice.bands > 0 ? tried.error(candidate, options.tolerance) : ErrorEstimate();
    plan.predicted_error = error.seen;
    if (error.at_most <= options.tolerance) break;  // that without a grid at the latest
  }
  plan.tried = tried.count();
  return plan;
}

std::vector<SeenHit> seen_hits(const Scene& scene, const RayCaster& caster, int across, const Options& options) {
  const int width = std::min(across, options.width), height = std::max(1, width * options.height / options.width);
  Progress progress(false);
  const Slice slice{0, height};
  const PrimaryHits hits = trace_primary(caster, scene.camera, width, height, slice, 1, {progress, "", 1.0});
  std::vector<SeenHit> seen;
  for (std::size_t pixel = 0; pixel < hits.pixel_count(); ++pixel) {
    if (const auto& hit = hits.of_pixel(pixel)[0]) seen.push_back({*hit, towards_camera(scene, *hit)});
  }
  return seen;
}

void measure(GridPlan& plan, const PlannedLighting& lighting, const LightField& field, const std::vector<SeenHit>& hits,
             const std::vector<Reflector>& reflectors, std::size_t points) {
  const std::unique_ptr<LightField> exact = lighting.exact();
  PlanPoints full{reflectors, hits, std::vector<glm::vec3>(hits.size())};
  std::vector<glm::vec3> planned(hits.size());
  const auto shade = [&](const LightField& by, std::vector<glm::vec3>& radiance) {
    for_each_in_parallel(static_cast<int>(hits.size()), [&](int i) {
      const SeenHit& seen = hits[static_cast<std::size_t>(i)];
      radiance[static_cast<std::size_t>(i)] = by.reflected(seen.hit, seen.outgoing, reflectors[seen.hit.material]);
    });
  };
  shade(field, planned);
  StageTimes times;
  times.time("", [&] { shade(*exact, full.radiance); });
  plan.measured_at = hits.size();
  plan.measured_error =
      estimate_error(full, 1, [&](std::size_t i) { return glm::dvec3(planned[i] - full.radiance[i]); }).seen;
  const auto share = static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(hits.size(), 1));
  plan.full_seconds = share * times.total();
}

}  // namespace example::grid_render
