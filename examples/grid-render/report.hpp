#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grid_plan.hpp"
#include "options.hpp"
#include "shared/image.hpp"
#include "shared/scene.hpp"
#include "shared/stage_times.hpp"

namespace example::grid_render {

/// The stages of a run, beside those of each pass, as the report names them.
namespace stage_name {
using namespace example::stage_name;
inline constexpr const char* lights = "lights";
inline constexpr const char* plan = "plan";
}  // namespace stage_name

/// A grid, as the report tells of it.
struct GridFacts {
  glm::ivec3 resolution{0};
  std::size_t bytes = 0;
  double seconds = 0.0;  // to build
  std::size_t visibility_bytes = 0;
};

/// How the light at a point comes about.
struct Technique {
  Shape shape;
  Method method;
  bool is_zonal = false;    // zonal by zonal, with the cosine of the centre (zonal_field.hpp)
  bool is_visible = false;  // by what is seen of the vertices
};

/// One way to the picture.
struct Pass {
  std::string name;
  Technique technique;
  std::optional<GridFacts> grid = std::nullopt;  // none: without a grid
  std::size_t lights = 0;                        // triangles, where the shape is made of them
  double seconds = 0.0;                          // interpolation, or projection, and shading
  Image picture = {};                            // linear radiance

  double total() const { return seconds + (grid ? grid->seconds : 0.0); }
};

/// A pass's picture beside what it stands for, another's.
struct Comparison {
  std::size_t picture, reference;  // numbers of passes
  std::string name;                // of the picture of differences
  ImageErrors errors = {};
  double leak = 0.0;  // root mean square of radiance where the reference is black, in units of its mean
};

struct Counts : RunCounts {
  std::size_t lights = 0;
};

/// Everything there is to say about a run.
struct Report {
  Options options;
  StageTimes times;
  Counts counts;
  Machine machine;
  Bounds box;                           // of the grids
  std::optional<GridPlan> plan;         // where there was a tolerance
  std::vector<Pass> passes;             // comparing interpolations, the reference, trilinear, and others
  std::vector<Comparison> comparisons;  // comparing interpolations, of each pass but the first with that
};

/// How much brighter than the differences of display values their pictures are.
constexpr float difference_factor = 40.0f;

/// How many vertices on an axis values alone would have in the time that the gradients' grid took to build, if a vertex
/// takes as long as in the trilinear grid of equal memory; for a cube. Zero where nothing was compared.
double equal_time_resolution(const Report& report);

/// Root mean square of the picture's radiance where the reference's is less than a thousandth of its mean, in units of
/// this mean.
double leak(const Image& picture, const Image& reference);

/// The aligned table for the terminal.
std::string table(const Report& report);

std::string json_text(const Report& report);

}  // namespace example::grid_render
