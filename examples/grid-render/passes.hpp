#pragma once

#include <vector>

#include "report.hpp"

namespace example::grid_render {

/// What a run renders, all of it still to do.
std::vector<Pass> passes_of(const Options& options);

/// What it compares, without the errors.
std::vector<Comparison> comparisons_of(const Options& options, const std::vector<Pass>& passes);

}  // namespace example::grid_render
