// Three numbers of any scalar as a vector: what kernels need of it. (GLM's vectors do not hold every scalar.) And what
// callers have for a direction, as three numbers.
//
// [1] T. Duff et al., "Building an Orthonormal Basis, Revisited", Journal of Computer Graphics Techniques 6(1), 2017.
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

// A vector of any length but 0 as a unit vector, and the reciprocal of its length.
template <class T>
struct UnitVector3 {
  T x, y, z, inverse_length;

  ZONAL_DEVICE ZONAL_INLINE constexpr UnitVector3(const T& vx, const T& vy, const T& vz)
      : x(vx), y(vy), z(vz), inverse_length(T(1) / sqrt(T(vx * vx + vy * vy + vz * vz))) {
    x = x * inverse_length, y = y * inverse_length, z = z * inverse_length;
  }
};

template <class T>
ZONAL_INLINE constexpr void cross3(const T (&a)[3], const T (&b)[3], T (&result)[3]) {
  for (int i = 0; i < 3; ++i) result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

}  // namespace detail

/// Two unit vectors that complete the unit vector z to a right-handed orthonormal frame, for any z [1]; it turns where
/// z passes through the plane z[2] = 0. Greatest error 3 ulp of 1 in any product of two of them.
template <class T>
ZONAL_INLINE constexpr void complete_frame(const T (&z)[3], T (&x)[3], T (&y)[3]) {
  const T sign = select(z[2] < T(0), T(-1), T(1));
  const T a = T(-1) / (sign + z[2]), b = z[0] * z[1] * a;
  x[0] = T(1) + sign * z[0] * z[0] * a, x[1] = sign * b, x[2] = -(sign * z[0]);
  y[0] = b, y[1] = sign + z[1] * z[1] * a, y[2] = -z[1];
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
