#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <zonal/grid/interpolation_weights.hpp>
#include <zonal/transform/window.hpp>

#include "shared/common_options.hpp"
#include "shared/field_setup.hpp"
#include "shared/material_change.hpp"

namespace example::field_render {

struct Options : CommonOptions {
  Options() { out = "field-render.png"; }

  std::string grid;                // a file
  std::string object = "figures";  // or table, or an OBJ file
  std::vector<MaterialChange> materials;
  zonal::Interpolation interpolation = zonal::Interpolation::trilinear;
  int bands = 5;  // of what is not matte; matte surfaces have three
  zonal::Window window = zonal::Window::none;

  std::optional<FieldSetup> reference;
  std::optional<Bounds> box;  // that the lamps are placed about
  int samples = 64;           // of a pixel
  int bounces = 3;
  std::uint64_t seed = 1;
};

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::field_render
