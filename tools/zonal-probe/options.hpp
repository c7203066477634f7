#pragma once

#include <optional>
#include <string>
#include <vector>

#include <zonal/convention/convention.hpp>
#include <zonal/transform/window.hpp>

#include "shared/common_options.hpp"

namespace zonal_probe {

enum class Format { text, json, cpp, glsl, hlsl };
enum class TurnAxis { up, right, ahead };

/// Counterclockwise as seen from the axis' end: `up` turns what was ahead to the left, `right` what was ahead upwards,
/// `ahead` what was up to the right.
struct Turn {
  TurnAxis axis;
  double degrees;
};

enum class WindowKind { none, hann, sinc, laplacian, automatic };
/// Of `automatic`: for which colours one window is chosen.
enum class WindowBy { all, channel, luminance };

struct WindowChoice {
  WindowKind kind = WindowKind::none;
  std::optional<double> width;  // none: the number of bands
  WindowBy by = WindowBy::all;
};

struct Options {
  std::string input;
  std::string mapping = "auto";
  std::optional<std::string> from;
  bool planes = false;
  std::optional<std::string> input_frame;

  std::optional<int> bands;
  std::string convention = "zonal";
  std::optional<zonal::Quantity> quantity;
  std::optional<std::string> frame;
  std::vector<Turn> turns;
  WindowChoice window;

  Format format = Format::text;
  std::string name = "probe";
  std::string out, preview;  // empty: standard output; none
  int threads = 0;
  bool quiet = false, list = false;
};

example::CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace zonal_probe
