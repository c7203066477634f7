#pragma once

#include <optional>
#include <string>

#include "options.hpp"
#include "shared/image.hpp"
#include "shared/stage_times.hpp"

namespace example::field_render {

/// Everything there is to say about a run.
struct Report {
  Options options;
  StageTimes times;
  RunCounts counts;
  Machine machine;
  Bounds box;  // the grid's
  glm::ivec3 resolution{0};
  int grid_bands = 0;
  std::optional<ImageErrors> errors;  // of the grid's picture, in a comparison
};

/// The aligned table for the terminal.
std::string table(const Report& report);

std::string json_text(const Report& report);

}  // namespace example::field_render
