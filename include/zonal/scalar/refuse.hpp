// What set-up does with arguments that cannot be, with and without exceptions.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// Throws std::invalid_argument(text). Compiled without exceptions (-fno-exceptions) it writes the text to standard
/// error and ends the program: such callers check their arguments first. Kernels never come here.
[[noreturn]] inline void refuse(const std::string& text) {
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
  throw std::invalid_argument(text);
#else
  std::fprintf(stderr, "zonal: %s\n", text.c_str());
  std::abort();
#endif
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
