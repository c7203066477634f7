#pragma once

#include <cstdint>
#include <string>

#include <zonal/screen/pattern.hpp>
#include <zonal/screen/surface.hpp>
#include <zonal/transform/window.hpp>

#include "shared/common_options.hpp"

namespace example::igi_render {

/// What is averaged over a block of pixels, and by which tests.
enum class Filter {
  radiance,           // coefficients of incident radiance
  irradiance,         // reflected light without its texture's colour, by geometry alone
  irradiance_strict,  // the same, where shading normals are alike too
  gaussian,           // six floats, read as a spherical Gaussian
  first_degree,       // the same six, read as L1 luminance and a colour
  none,               // as radiance, and nothing averaged
};

enum class Lighting {
  spot,   // the scene's spotlight
  three,  // three coloured points
  area,   // the scene's panel
  probe,  // a picture of the surroundings
};

struct Options : CommonOptions {
  Options() {
    out = "igi-render.png";
    antialias = 1;
  }

  Filter filter = Filter::radiance;
  int bands = 3;
  zonal::Window window = zonal::Window::none;  // of radiance, where gloss is shaded
  bool half = false;
  zonal::InterleavedPattern pattern{4, 4};
  zonal::SurfaceTests tests;

  Lighting lighting = Lighting::three;
  std::string probe;
  int samples = 8;  // of each set: of an area light or a probe, and of paths
  int bounces = 1;
  float least_distance = 0.0f;  // metres; 0: a fiftieth of the scene's radius
  std::uint64_t seed = 1;
};

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::igi_render
