// What the times were measured on.
#pragma once

#include <string>

namespace zonal_bench {

/// Compiler, flags, and the instruction set that they ask for.
std::string compiler();

/// The processor's name.
std::string processor();

}  // namespace zonal_bench
