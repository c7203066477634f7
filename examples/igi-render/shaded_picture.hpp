#pragma once

#include <cstddef>
#include <vector>

#include "screen_scene.hpp"
#include "shared/image.hpp"
#include "shared/progress.hpp"
#include "shared/stage_times.hpp"

namespace example::igi_render {

/// What a filter did.
struct Pass {
  std::string name;
  Image picture{};
  double light_seconds = 0.0, filter_seconds = 0.0, shading_seconds = 0.0;
  int numbers = 0;        // a position, that are filtered
  std::size_t bytes = 0;  // of all of them
  ImageErrors errors{};

  double seconds() const { return light_seconds + filter_seconds + shading_seconds; }
};

/// Light from the set of each position, filtered, and made a picture of outgoing radiance.
Pass filtered_pass(const ScreenScene& screen, Filter filter, Progress& progress);

/// Light of all sets at every position, by the materials themselves; and by as many bands as the radiance filter has.
struct Reference {
  Pass exact, truncated;
};
Reference reference_pass(const ScreenScene& screen, Progress& progress);

/// Rough costs in rays: of a filtered pass, and of the reference.
double pass_cost(const ScreenScene& screen);
double reference_cost(const ScreenScene& screen);

}  // namespace example::igi_render
