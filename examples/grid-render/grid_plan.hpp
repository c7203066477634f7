#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lighting.hpp"
#include "windowed_light.hpp"

namespace example::grid_render {

/// Where the light at a point comes from: a grid of what is far, and what is near, light by light. Without bands there
/// is no grid, and every light is near.
struct GridChoice {
  int bands = 0;
  zonal::Interpolation method = zonal::Interpolation::hermite;
  glm::ivec3 resolution{0};
  NearRange near = {};

  GridContent content() const {
    return method == zonal::Interpolation::hermite ? GridContent::values_and_gradients : GridContent::values;
  }
};

/// A point, and where it is seen from.
struct SeenHit {
  Hit hit;
  glm::vec3 outgoing;
};

/// Points by which a grid is planned, and what they reflect of all lights.
struct PlanPoints {
  const std::vector<Reflector>& reflectors;
  std::vector<SeenHit> hits;
  std::vector<glm::vec3> radiance;
};

/// A root mean square error relative to that of the radiance, of some points; and what it is at most of all points that
/// these are drawn from, by three standard errors.
struct ErrorEstimate {
  double seen = 0.0, at_most = 0.0;
};

/// A way to read a grid, and its error.
struct GridWay {
  int bands;
  zonal::Interpolation method;
  ErrorEstimate error;
};

/// A field with what is to be said of it.
struct PlannedField {
  std::unique_ptr<LightField> field;
  std::size_t near_bytes = 0;
  double fill_seconds = 0.0;
};

/// Sphere lights as plans want them.
class PlannedLighting : public Interface {
 public:
  virtual std::unique_ptr<LightField> exact() const = 0;
  /// What the points reflect of all lights, of so many bands.
  virtual std::vector<glm::vec3> radiance(const std::vector<SeenHit>& hits, const std::vector<Reflector>& reflectors,
                                          int bands) const = 0;
  /// All ways of a grid with these cells, at every `one_of`th point.
  virtual std::vector<GridWay> errors(const PlanPoints& points, std::size_t one_of, const Bounds& box,
                                      const glm::ivec3& resolution, const NearRange& near) const = 0;
  virtual PlannedField field(const Bounds& box, const GridChoice& choice) const = 0;
};

/// Of a difference at every `one_of`th point.
template <class Difference>
ErrorEstimate estimate_error(const PlanPoints& points, std::size_t one_of, const Difference& difference) {
  double sum = 0.0, squares = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < points.hits.size(); i += one_of) {
    const glm::dvec3 of_point = difference(i), radiance(points.radiance[i]);
    const double square = glm::dot(of_point, of_point);
    sum += square;
    squares += square * square;
    whole += glm::dot(radiance, radiance);
  }
  if (!(whole > 0.0)) return {};
  return {std::sqrt(sum / whole), std::sqrt((sum + 3.0 * std::sqrt(squares)) / whole)};
}

std::unique_ptr<PlannedLighting> make_planned_lighting(const SphereLights& lights, int bands);

/// What a tolerance led to.
struct GridPlan {
  GridChoice choice;
  double predicted_error = 0.0;  // at the points of a small picture
  std::size_t predicted_at = 0;
  double near_lights = 0.0;  // of a point, mean
  std::size_t tried = 0;     // grids whose errors were looked at

  std::size_t near_bytes = 0, light_bytes = 0;

  // Where it is to be explained, at other points:
  std::size_t measured_at = 0;
  double measured_error = 0.0;
  double full_seconds = 0.0;  // that all lights at each point of the picture would take
};

/// The cheapest choice that is within the tolerance at the points: of resolutions, bands, methods, and near ranges.
GridPlan plan_grid(const PlannedLighting& lighting, const SphereLights& lights, std::vector<SeenHit> hits,
                   const std::vector<Reflector>& reflectors, const Bounds& box, const Options& options);

/// What a picture of so many pixels across sees, a point each.
std::vector<SeenHit> seen_hits(const Scene& scene, const RayCaster& caster, int across, const Options& options);

/// The field's error at other points than it was planned by, and what they take without a grid.
void measure(GridPlan& plan, const PlannedLighting& lighting, const LightField& field, const std::vector<SeenHit>& hits,
             const std::vector<Reflector>& reflectors, std::size_t points);

}  // namespace example::grid_render
