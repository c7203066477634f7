// Square roots and powers at compile time, for tables that are computed from their formulas.
#pragma once

#include "target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

inline constexpr long double kPi = 3.14159265358979323846264338327950288L;

// pi / 2 as the double next to it and what is missing: together they are exact enough for any T, where long double is
// no longer than double as well.
inline constexpr long double kHalfPiDouble = 0x1.921fb54442d18p+0L, kHalfPiRest = 0x1.1a62633145c07p-54L;

/// sqrt(x) for 0 <= x < 1e30, to the last bit or one beside it, by Newton's method from above; at run time the
/// processor's own.
constexpr long double constexpr_sqrt(long double x) {
#if (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 9)) && !defined(__CUDACC__)
  if (!__builtin_is_constant_evaluated()) return __builtin_sqrtl(x);
#endif
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
