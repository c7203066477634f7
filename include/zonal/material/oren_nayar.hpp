// A rough diffuse surface that keeps the energy: EON.
//
// Oren and Nayar's V-grooves in Fujii's form, which has a closed albedo E, and what they lose by single scattering
// added as a lobe (1 - E(wi)) (1 - E(wo)) [1]. A white one reflects all, from wherever it is seen.
//
// [1] J. Portsmouth, P. Kutz, S. Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", JCGT 14(1), 2025.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "../scalar/math.hpp"
#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// albedo: RGB in [0, 1], of the facets; the surface's own is diffuse_albedo(). roughness: 0, which is Lambert's, to 1.
struct OrenNayarBrdf {
  glm::vec3 albedo;
  float roughness;
};

namespace detail {

/// [1]: of the white single-scattering lobe, its factor A, and its mean albedo.
template <class T>
T oren_nayar_factor(T roughness) {
  return T(1) / (T(1) + T(0.5L - 2 / (3 * kPi)) * roughness);
}
template <class T>
T oren_nayar_mean(T roughness) {
  return oren_nayar_factor(roughness) * (T(1) + T(2 / 3.0L - 28 / (15 * kPi)) * roughness);
}

/// Its albedo seen at cos_angle in [0, 1]. (1 - sin^3) / cos, which cancels, is cos (1 + sin + sin^2) / (1 + sin).
template <class T>
ZONAL_INLINE inline T oren_nayar_albedo(const T& cos_angle, T roughness) {
  const T c = clamp(cos_angle, T(0), T(1)), s = sqrt((T(1) - c) * (T(1) + c));
  const T g = s * (acos(c) - s * c) + T(2 / 3.0L) * (s * c * (T(1) + s + s * s) / (T(1) + s) - s);
  return oren_nayar_factor(roughness) * (T(1) + roughness * T(1 / kPi) * g);
}

/// What light that is scattered more than once has of the colour.
template <class T>
glm::vec<3, T> oren_nayar_bounces(const OrenNayarBrdf& brdf) {
  const T mean = oren_nayar_mean(T(brdf.roughness));
  const glm::vec<3, T> rho(brdf.albedo);
  const auto channel = [&](const T& r) { return r * r * mean / (T(1) - r * (T(1) - mean)); };
  return {channel(rho.x), channel(rho.y), channel(rho.z)};
}

}  // namespace detail

template <class T>
glm::vec<3, T> evaluate(const OrenNayarBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const T roughness = T(brdf.roughness);
  const T s = wi.x * wo.x + wi.y * wo.y;
  const T ratio = select(s > T(0), s / maximum(maximum(wi.z, wo.z), T(1e-18)), s);
  const T single = detail::oren_nayar_factor(roughness) * (T(1) + roughness * ratio);
  const T lost_i = maximum(T(1) - detail::oren_nayar_albedo(wi.z, roughness), T(0));
  const T lost_o = maximum(T(1) - detail::oren_nayar_albedo(wo.z, roughness), T(0));
  const T lost = maximum(T(1) - detail::oren_nayar_mean(roughness), T(1e-7));  // of a smooth surface nothing is
  const glm::vec<3, T> value =
      glm::vec<3, T>(brdf.albedo) * single + detail::oren_nayar_bounces<T>(brdf) * (lost_i * lost_o / lost);
  return detail::or_black<T>(detail::above_horizon(wi, wo), value * T(1 / kPi));
}

/// Exact: the integral of f cos.
inline glm::vec3 diffuse_albedo(const OrenNayarBrdf& brdf, float cos_outgoing) {
  const float single = detail::oren_nayar_albedo(cos_outgoing, brdf.roughness);
  return brdf.albedo * single + detail::oren_nayar_bounces<float>(brdf) * (1.0F - single);
}
inline float approximate_albedo(const OrenNayarBrdf& brdf, const glm::vec3& wo) {
  return detail::mean(diffuse_albedo(brdf, wo.z));
}
inline bool is_diffuse(const OrenNayarBrdf&) { return true; }

// Directions: by the cosine, and, of a rough surface up to a quarter, uniform, for what it sends back towards grazing
// light.

inline glm::vec3 sample_lobe(const OrenNayarBrdf& brdf, const glm::vec3&, const glm::vec2& u) {
  const float share = 0.25F * brdf.roughness, phi = 2.0F * float(kPi) * u.y;
  const bool uniform = u.x < share;
  const float v = uniform ? u.x / share : (u.x - share) / (1.0F - share);
  const float squared_sine = uniform ? v * (2.0F - v) : v, sine = std::sqrt(squared_sine);
  return {sine * std::cos(phi), sine * std::sin(phi), uniform ? 1.0F - v : std::sqrt((std::max)(1.0F - v, 0.0F))};
}
template <class T>
ZONAL_INLINE inline T lobe_pdf(const OrenNayarBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3&) {
  const T share = T(0.25F * brdf.roughness);
  return (T(1) - share) * wi.z * T(1 / kPi) + share * T(0.5L / kPi);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
