// Memory that will be read soon.
#pragma once

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// Fetches the cache line of this place meanwhile. Any address will do.
inline void prefetch([[maybe_unused]] const void* memory) {
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#endif
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
