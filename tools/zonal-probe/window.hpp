#pragma once

#include <array>
#include <string>

#include "light.hpp"
#include "options.hpp"

namespace zonal_probe {

/// What a window does to a channel. Errors are relative to what was there before, by norms over the sphere.
struct WindowedChannel {
  double width = 0;  // 0: none
  double error = 0, irradiance_error = 0;
  double least_before = 0, least_after = 0;  // of `of`, over all directions; in units of its mean
};

struct Windowed {
  WindowKind kind = WindowKind::none;              // never `automatic`: what was found
  zonal::Quantity of = zonal::Quantity::radiance;  // what is not to be negative: radiance, or E / pi
  bool is_possible = true;                         // false where a mean is not positive: then there is none
  std::array<WindowedChannel, 3> channels{};
};

/// Multiplies the light's degrees by the window. of: the quantity that will be written.
Windowed apply_window(Light& light, const WindowChoice& choice, zonal::Quantity of);

/// Has it changed anything?
bool is_windowed(const Windowed& windowed);

/// One line.
std::string window_text(const Windowed& windowed);

}  // namespace zonal_probe
