// What a lobe leaves, reflected diffusely; energy.hpp makes it.
//
// [1] C. Kelemen, L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model with Importance Sampling",
//     Eurographics 2001 short presentations.
#pragma once

#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A diffuse lobe that reflects of what another lobe leaves the share `albedo`, RGB in [0, 1] [1]:
///
///   f = albedo left(wi) left(wo) / (pi mean),   mean = integral of left(wi) cos / pi dwi
///
/// It is reciprocal, and its albedo seen from wo is albedo left(wo), so that the two lobes together reflect at most
/// all. It serves a body under a coat and for what light does between microfacets.
struct ResidualBrdf {
  static constexpr int degree = 13;

  glm::vec3 albedo, mean;
  float scale;                      // of the cosine: t = 2 sqrt((1 + scale) cos / (scale + cos)) - 1
  glm::vec3 chebyshev[degree + 1];  // of left, the other lobe's albedo taken from 1, by polynomials in t
};

/// The share, RGB in [0, 1], that the other lobe leaves of the light at cos_angle in [0, 1] to the normal.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> left_at(const ResidualBrdf& brdf, const T& cos_angle) {
  const T cosine = clamp(cos_angle, T(0), T(1)), scale = T(brdf.scale);
  const T t2 = T(4) * sqrt((T(1) + scale) * cosine / (scale + cosine)) - T(2);  // 2 t
  const auto term = [&](int k) ZONAL_INLINE { return glm::vec<3, T>(brdf.chebyshev[k]); };
  glm::vec<3, T> next(T(0)), sum = term(ResidualBrdf::degree);  // Clenshaw's
  for (int k = ResidualBrdf::degree - 1; k >= 1; --k) {
    const glm::vec<3, T> before = sum * t2 - next + term(k);
    next = sum;
    sum = before;
  }
  const glm::vec<3, T> left = sum * (T(0.5) * t2) - next + term(0);
  return {clamp(left.x, T(0), T(1)), clamp(left.y, T(0), T(1)), clamp(left.z, T(0), T(1))};
}

template <class T>
glm::vec<3, T> evaluate(const ResidualBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const glm::vec<3, T> mean(brdf.mean), normalised = glm::vec<3, T>(brdf.albedo) * T(1 / kPi);
  const glm::vec<3, T> both = left_at(brdf, wi.z) * left_at(brdf, wo.z) * normalised;
  // Where next to nothing is left, there is no mean to divide by.
  const T least = T(1e-12);
  const glm::vec<3, T> value(both.x / maximum(mean.x, least), both.y / maximum(mean.y, least),
                             both.z / maximum(mean.z, least));
  return detail::or_black<T>(detail::above_horizon(wi, wo), value);
}

// Directions by the cosine, the default: what is left varies little over it.

inline glm::vec3 diffuse_albedo(const ResidualBrdf& brdf, float cos_outgoing) {
  return brdf.albedo * left_at(brdf, cos_outgoing);
}
inline float approximate_albedo(const ResidualBrdf& brdf, const glm::vec3& wo) {
  return detail::mean(diffuse_albedo(brdf, wo.z));
}
inline bool is_diffuse(const ResidualBrdf&) { return true; }

}  // namespace ZONAL_TARGET
}  // namespace zonal
