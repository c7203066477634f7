#pragma once

#include "options.hpp"

namespace zonal_probe {

constexpr const char* program_name = "zonal-probe";

/// All that the options ask for. Throws InputError, Interrupted.
void run(const Options& options);

}  // namespace zonal_probe
