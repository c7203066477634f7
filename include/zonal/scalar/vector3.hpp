// Three numbers of any scalar as a vector: what kernels need of it. (GLM's vectors do not hold every scalar.)
#pragma once

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

template <class T>
ZONAL_INLINE constexpr T dot3(const T (&a)[3], const T (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
ZONAL_INLINE constexpr void cross3(const T (&a)[3], const T (&b)[3], T (&result)[3]) {
  for (int i = 0; i < 3; ++i) result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
