// Spherical Gaussians (SG) in any direction: their integrals, and their products, which are SGs again.
//
// Exponents such as |a + b| - a - b, differences of large numbers, are written as quotients: with c the cosine between
// the axes, -2 a b (1 - c) / (|a + b| + a + b).
#pragma once

#include "../scalar/math.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The integral of exp(sharpness (cos - 1)) over the sphere.
template <class T>
ZONAL_INLINE inline T gaussian_integral(const T& sharpness) {
  const T safe = maximum(sharpness, T(1e-3L));
  return T(2 * kPi) * (T(1) - exp(T(-2) * safe)) / safe;
}

/// 1 - cos of the angle between two unit vectors: from their difference, which does not cancel.
template <class T>
ZONAL_INLINE inline T one_minus_cosine(const T (&a)[3], const T (&b)[3]) {
  const T difference[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return T(0.5L) * dot3(difference, difference);
}

/// The product of two SGs of one pole each: axis and sharpness, and the logarithm of the coefficient.
template <class T>
struct GaussianProduct {
  T axis[3], sharpness, exponent;
};
template <class T>
ZONAL_INLINE inline GaussianProduct<T> product(const T (&a)[3], const T& a_sharpness, const T (&b)[3],
                                               const T& b_sharpness) {
  GaussianProduct<T> result;
  for (int i = 0; i < 3; ++i) result.axis[i] = a_sharpness * a[i] + b_sharpness * b[i];
  result.sharpness = maximum(sqrt(dot3(result.axis, result.axis)), T(1e-6L));
  const T inverse = T(1) / result.sharpness;
  for (T& component : result.axis) component = component * inverse;
  result.exponent =
      T(-2) * a_sharpness * b_sharpness * one_minus_cosine(a, b) / (result.sharpness + a_sharpness + b_sharpness);
  return result;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
