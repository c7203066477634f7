// Three numbers of any scalar as a vector: what kernels need of it. (GLM's vectors do not hold every scalar.) And what
// callers have for a direction, as three numbers.
#pragma once

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

template <class T>
struct Direction3 {
  T x, y, z;
};

/// The one place where a caller's direction or position is read: v[0], v[1], v[2], or else v.x, v.y, v.z, as three T.
template <class T, class V>
ZONAL_INLINE constexpr auto as_direction(const V& v, int) -> decltype(v[0], Direction3<T>{}) {
  return {T(v[0]), T(v[1]), T(v[2])};
}
template <class T, class V>
ZONAL_INLINE constexpr auto as_direction(const V& v, long) -> decltype(v.x, Direction3<T>{}) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T, class V>
ZONAL_INLINE constexpr Direction3<T> as_direction(const V& v) {
  return as_direction<T>(v, 0);
}

// Where these numbers stand.
template <class V>
constexpr auto component_addresses(const V& v, int) -> decltype(Direction3<decltype(&v[0])>{}) {
  return {&v[0], &v[1], &v[2]};
}
template <class V>
constexpr auto component_addresses(const V& v, long) -> decltype(Direction3<decltype(&v.x)>{}) {
  return {&v.x, &v.y, &v.z};
}

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
