#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/glm.hpp>
#include <zonal/environment/mapping.hpp>
#include <zonal/field/sequence.hpp>

#include "shared/common_options.hpp"
#include "shared/field_setup.hpp"

namespace example::field_capture {

/// Where probes stand in the box: at the points of a regular grid; in three planes through its middle, one across each
/// axis; or one in each cell of a grid, anywhere.
enum class Layout { grid, planes, random };

struct Options : CommonOptions {
  Options() { out = "capture"; }

  FieldSetup setup = FieldSetup::projector;
  std::optional<Bounds> box;
  int probes = 1000;
  Layout layout = Layout::random;

  int side = 128;  // texels
  zonal::Mapping mapping = zonal::Mapping::mirror_sphere;
  std::optional<float> sphere_radius;  // metres; of a mirror sphere 0.05 where it is not said
  float dead_angle = 4.2f;             // degrees
  zonal::DeadAngle dead_angle_is = zonal::DeadAngle::black;

  int samples = 8;  // paths a texel
  int bounces = 3;
  std::uint64_t seed = 1;

  std::string truth;  // a file of positions; empty: capture
  int bands = 5;
  int truth_samples = 65536;  // paths a position

  bool is_mirror() const { return mapping == zonal::Mapping::mirror_sphere; }
};

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::field_capture
