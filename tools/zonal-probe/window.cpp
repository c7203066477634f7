#include "window.hpp"

#include <algorithm>
#include <cmath>

#include <zonal/environment/irradiance.hpp>
#include <zonal/probe/dering.hpp>
#include <zonal/probe/least_value.hpp>

#include "shared/text_table.hpp"

namespace zonal_probe {
namespace {

using Function = zonal::Sh<max_bands, double>;
using zonal::Quantity;

Function single_channel(const Coefficients& sh, int channel) {
  Function f{};
  for (int i = 0; i < f.size(); ++i) f[i] = sh[i][channel];
  return f;
}

double relative_error(const Function& before, const Function& after) {
  const double square = zonal::dot(before, before);
  return square > 0 ? std::sqrt(zonal::dot(before - after, before - after) / square) : 0;
}

double least_share(const Function& f) {
  const double mean = f[0] * std::sqrt(0.25 / pi);
  return mean > 0 ? zonal::least_value(f, 1e-4 * mean).value / mean : 0;
}

zonal::DeringBy by_of(WindowBy by) {
  return by == WindowBy::channel     ? zonal::DeringBy::channel
         : by == WindowBy::luminance ? zonal::DeringBy::luminance
                                     : zonal::DeringBy::all_channels;
}

zonal::DeringWindow window_of(WindowKind kind) {
  return kind == WindowKind::hann   ? zonal::DeringWindow::hann
         : kind == WindowKind::sinc ? zonal::DeringWindow::lanczos
                                    : zonal::DeringWindow::laplacian;
}

std::string percent(double share) { return example::format("%.3g %%", 100 * share); }

/// One text, or one for each channel where they differ.
template <class Text>
std::string of_channels(const Windowed& windowed, const Text& text) {
  const std::string first = text(windowed.channels[0]);
  const bool are_equal = text(windowed.channels[1]) == first && text(windowed.channels[2]) == first;
  if (are_equal) return first;
  return first + ", " + text(windowed.channels[1]) + ", " + text(windowed.channels[2]);
}

}  // namespace

Windowed apply_window(Light& light, const WindowChoice& choice, Quantity of) {
  Windowed windowed;
  windowed.kind = choice.kind == WindowKind::automatic ? WindowKind::laplacian : choice.kind;
  windowed.of = of == Quantity::radiance ? Quantity::radiance : Quantity::irradiance_over_pi;
  if (choice.kind == WindowKind::none) return windowed;
  const Coefficients before = of_quantity(light, Quantity::radiance).sh;
  if (choice.kind == WindowKind::automatic) {
    zonal::DeringOptions options;
    options.window = window_of(windowed.kind);
    options.of = windowed.of == Quantity::radiance ? zonal::DeringOf::radiance : zonal::DeringOf::irradiance;
    options.by = by_of(choice.by);
    const auto dering = zonal::dering(before, options);
    windowed.is_possible = dering.is_possible;
    for (std::size_t c = 0; c < 3; ++c) {
      const double strength = dering.channels[c].strength;
      windowed.channels[c].width = strength > 0 ? 1 / strength : 0;
    }
  } else {
    for (WindowedChannel& channel : windowed.channels) channel.width = choice.width.value_or(light.bands);
  }

  Coefficients after = before;
  for (int c = 0; c < 3; ++c) {
    const double width = windowed.channels[static_cast<std::size_t>(c)].width;
    if (!(width > 0)) continue;
    for (int l = 0, i = 0; l < max_bands; ++l) {
      const double factor = zonal::dering_factor(window_of(windowed.kind), l, 1 / width);
      for (; i < (l + 1) * (l + 1); ++i) light.sh[i][c] *= factor, after[i][c] *= factor;
    }
  }
  for (int c = 0; c < 3; ++c) {
    WindowedChannel& channel = windowed.channels[static_cast<std::size_t>(c)];
    const Function f = single_channel(before, c), g = single_channel(after, c);
    const Function f_irradiance = zonal::irradiance_over_pi(f), g_irradiance = zonal::irradiance_over_pi(g);
    channel.error = relative_error(f, g);
    channel.irradiance_error = relative_error(f_irradiance, g_irradiance);
    const bool is_radiance = windowed.of == Quantity::radiance;
    channel.least_before = least_share(is_radiance ? f : f_irradiance);
    channel.least_after = least_share(is_radiance ? g : g_irradiance);
  }
  return windowed;
}

bool is_windowed(const Windowed& windowed) {
  return std::any_of(windowed.channels.begin(), windowed.channels.end(),
                     [](const WindowedChannel& channel) { return channel.width > 0; });
}

std::string window_text(const Windowed& windowed) {
  if (windowed.kind == WindowKind::none) return "none";
  const std::string of = windowed.of == Quantity::radiance ? "radiance" : "irradiance";
  if (!windowed.is_possible) return "none: the mean " + of + " is not positive, and no window helps";
  const std::string least =
      of_channels(windowed, [](const auto& c) { return example::format("%.3g", c.least_before); });
  if (!is_windowed(windowed)) {
    return "none is needed; least " + of + " " + least + " of its mean";
  }
  const std::string kind = windowed.kind == WindowKind::hann   ? "hann"
                           : windowed.kind == WindowKind::sinc ? "sinc"
                                                               : "laplacian";
  return kind + " of width " +
         of_channels(
             windowed,
             [](const auto& c) { return c.width > 0 ? example::format("%.4g", c.width) : std::string("none"); }) +
         "; changes radiance by " + of_channels(windowed, [](const auto& c) { return percent(c.error); }) +
         ", irradiance by " + of_channels(windowed, [](const auto& c) { return percent(c.irradiance_error); }) +
         "; least " + of + " " + least + " of its mean before, " +
         of_channels(windowed, [](const auto& c) { return example::format("%.3g", c.least_after); }) + " after";
}

}  // namespace zonal_probe
