#pragma once

#include <optional>
#include <string>

#include "light.hpp"
#include "shared/image.hpp"
#include "workers.hpp"

namespace zonal_probe {

/// What the preview shows beside the light itself.
struct PreviewTexts {
  std::string picture, window;
};

/// Display values: the picture, what the coefficients make of it, the difference, and a white ball in their light; the
/// last two of these alone where there is no picture.
example::Image make_preview(const Light& light, const std::optional<example::Image>& sky, const PreviewTexts& texts,
                            Workers& workers);

/// Of the picture and of what the coefficients make of it.
constexpr int panel_width = 480, panel_height = 240;

}  // namespace zonal_probe
