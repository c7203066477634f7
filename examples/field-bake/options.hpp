#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <zonal/field/resample.hpp>
#include <zonal/field/thin.hpp>

#include "shared/common_options.hpp"

namespace example::field_bake {

/// How a field is resampled: `plane` is the library's way, `space` the paper's steps, its reference.
enum class Path { plane, space };

struct Options {
  std::string sequence;
  std::string out = "field.grid";
  std::string work;  // empty: beside the grid
  bool keep_work = false;

  glm::ivec3 resolution{16};
  std::optional<Bounds> box;  // none: of the probes
  int bands = 5;
  bool gradients = false;
  bool half = false;  // 16 bits

  zonal::Resampling resampling;
  Path path = Path::plane;
  std::optional<zonal::Thinning> thinning;

  int memory = 64;  // MiB
  std::string report;
  int threads = 0;  // 0: all
  bool quiet = false;
};

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::field_bake
