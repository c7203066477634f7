#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "options.hpp"
#include "shaded_picture.hpp"
#include "shared/stage_times.hpp"

namespace example::igi_render {

struct Counts : RunCounts {
  std::size_t lights = 0;  // of all sets
  std::size_t surface_bytes = 0;
};

/// Everything there is to say about a run.
struct Report {
  Options options;
  StageTimes times;
  Counts counts;
  Machine machine;
  std::vector<Pass> passes;
  std::optional<Reference> reference;  // in a comparison
};

/// The aligned table for the terminal.
std::string table(const Report& report);

std::string json_text(const Report& report);

}  // namespace example::igi_render
