// From a number of bands known at run time to one known at compile time.
#pragma once

#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Calls f(Index<bands>{}) and returns true if Min <= bands <= Max; returns false, calling nothing, if not.
///   dispatch_bands<1, 10>(bands, [&](auto n) { draw<n>(scene); });
template <int Min, int Max, class F>
constexpr bool dispatch_bands(int bands, F&& f) {
  static_assert(1 <= Min && Min <= Max, "bands out of range: 1 <= Min <= Max");
  bool found = false;
  unroll<Min, Max + 1>([&](auto n) {
    if (bands == n) {
      f(n);
      found = true;
    }
  });
  return found;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
