// Square roots and powers at compile time, for tables that are computed from their formulas.
#pragma once

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

inline constexpr long double kPi = 3.14159265358979323846264338327950288L;

/// sqrt(x) for 0 <= x < 1e30, to the last bit or one beside it, by Newton's method from above.
constexpr long double constexpr_sqrt(long double x) {
  if (x <= 0) return 0;
  long double root = x > 1 ? x : 1;
  for (;;) {
    const long double next = (root + x / root) / 2;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
