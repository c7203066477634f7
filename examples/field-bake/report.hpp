#pragma once

#include <cstddef>
#include <string>

#include <zonal/environment/picture.hpp>

#include "options.hpp"
#include "shared/stage_times.hpp"

namespace example::field_bake {

/// What a bake was, and what it took.
struct Report {
  Options options;
  Machine machine;
  StageTimes times;
  Bounds box{};
  std::size_t probes = 0, thinned = 0;  // of the sequence, and those left out
  std::size_t buckets = 0;
  std::size_t pictures_read = 0, blocks_done = 0;  // in this run
  std::size_t blocks = 0;
  std::size_t ranks = 1;
  zonal::PictureFaults faults;  // of the pictures read
  std::size_t grid_bytes = 0;
};

/// The largest memory that this process has had, bytes; 0 where the system does not say.
std::size_t peak_memory();

/// For the terminal.
std::string text(const Report& report);
/// For --report.
std::string json_text(const Report& report);

}  // namespace example::field_bake
