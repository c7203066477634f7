#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "options.hpp"
#include "planned_gather.hpp"
#include "shared/image.hpp"
#include "shared/stage_times.hpp"

namespace example::hvl_render {

/// The stages of a run, as the report names them.
namespace stage_name {
using namespace example::stage_name;
inline constexpr const char* budget = "number of lights";
inline constexpr const char* lights = "virtual lights";
inline constexpr const char* plan = "plan";
inline constexpr const char* direct = "direct light";
inline constexpr const char* gather = "gather";
inline constexpr const char* paths = "paths";
}  // namespace stage_name

struct Counts : RunCounts {
  std::size_t map_lights = 0;      // of the square map
  std::size_t virtual_lights = 0;  // those that carry light
  int samples_per_pixel = 0;       // paths
};

/// Everything there is to say about a run.
struct Report {
  Options options;
  StageTimes times;
  Counts counts;
  Machine machine;
  double material_error = 0.0;      // greatest of the projections, of each table's largest coefficient
  std::optional<PlanFigures> plan;  // where there was a tolerance
  std::optional<ScenePlan> scene_plan;
  LightBytes light_bytes;
  TableBytes table_bytes;
  std::vector<std::string> material_names;
  std::optional<ImageErrors> errors;  // where there was something to compare with
};

/// Nanoseconds of wall-clock time, all threads together, per primary hit and virtual light; zero without
/// lights.
double nanoseconds_per_gather(const Report& report);

/// What a time budget is for: shooting the virtual lights, and gathering them.
double light_seconds(const Report& report);

/// Seconds that the full gather would take on all threads, where a plan was checked; else 0.
double full_gather_seconds(const Report& report);

/// The aligned table for the terminal.
std::string table(const Report& report);

std::string json_text(const Report& report);

}  // namespace example::hvl_render
