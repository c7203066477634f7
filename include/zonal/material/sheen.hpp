// The sheen of cloth: microfibres that stand off the surface, bright at grazing angles, after Estevez and Kulla [1],
// without their softened terminator, which is not reciprocal.
//
// It is thin, and stands on something: sheen_albedo() is what it reflects of uniform light, at most 0.95 of its colour.
// [1] scales the base by 1 - max(colour) sheen_albedo(wo); so scaled the two reflect at most all, but not reciprocally.
//
// [1] A. Conty Estevez, C. Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include "ggx.hpp"
#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// colour: RGB in [0, 1]. roughness: 0.1 to 1; below it counts as 0.1, where the lobe would come to reflect more than
/// all, above as 1.
struct SheenBrdf {
  glm::vec3 colour;
  float roughness;
};

namespace detail {

inline float sheen_roughness(float roughness) { return clamp(roughness, 0.1F, 1.0F); }

/// [1]'s fit of Smith's Lambda, at cos_angle in (0, 1].
template <class T>
T sheen_lambda(T cos_angle, T roughness) {
  const T smooth = (T(1) - roughness) * (T(1) - roughness);
  const auto blend = [&](double at_0, double at_1) { return smooth * T(at_0) + (T(1) - smooth) * T(at_1); };
  const T a = blend(25.3245, 21.5473), b = blend(3.32435, 3.82987), c = blend(0.16801, 0.19823),
          d = blend(-1.27393, -1.97760), e = blend(-4.85967, -4.32054);
  const auto fit = [&](T x) { return a / (T(1) + b * std::pow(x, c)) + d * x + e; };
  return cos_angle < T(0.5) ? std::exp(fit(cos_angle)) : std::exp(T(2) * fit(T(0.5)) - fit(T(1) - cos_angle));
}

/// For colour 1: the distribution of half vectors, (2 + 1 / alpha) sin^(1 / alpha) / (2 pi), times visibility.
template <class T>
T sheen_value(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo, T roughness) {
  const T sharpness = T(1) / roughness;
  const T distribution =
      (T(2) + sharpness) / T(2 * kPi) * std::pow(half_vector(wi, wo).squared_sine, T(0.5) * sharpness);
  const T shadow = T(1) + (sheen_lambda(wi.z, roughness) + sheen_lambda(wo.z, roughness));
  return distribution / (T(4) * shadow * maximum(wi.z * wo.z, T(1e-30)));
}

}  // namespace detail

template <class T>
glm::vec<3, T> evaluate(const SheenBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    if (!detail::above_horizon(wi, wo)) return glm::vec<3, T>(T(0));
    return glm::vec<3, T>(brdf.colour) * detail::sheen_value(wi, wo, T(detail::sheen_roughness(brdf.roughness)));
  } else {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  }
}

/// What a sheen of colour 1 reflects of uniform light, seen at cos_outgoing in (0, 1]. Greatest error: 3e-3.
inline double sheen_albedo(float roughness, double cos_outgoing) {
  constexpr int rings = 64, spokes = 64;
  const double alpha = double(detail::sheen_roughness(roughness));
  const glm::dvec3 wo(std::sqrt((1.0 - cos_outgoing) * (1.0 + cos_outgoing)), 0.0, cos_outgoing);
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double x = (i + 0.5) / rings, z = x * x, sine = std::sqrt((1.0 - z) * (1.0 + z));  // crowded at the horizon
    const double weight = z * 2.0 * x / rings * 2.0 * double(kPi) / spokes;
    for (int j = 0; j < spokes; ++j) {
      const double phi = double(kPi) * (j + 0.5) / spokes;  // both halves are alike
      sum += detail::sheen_value(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), z), wo, alpha) * weight;
    }
  }
  return sum;
}

/// Of roughness 0.5, about: 0.09 along the normal, 0.85 towards the horizon.
inline glm::vec3 diffuse_albedo(const SheenBrdf& brdf, float cos_outgoing) {
  const float x = 1.0F - cos_outgoing;
  return brdf.colour * (0.1F + 0.75F * x * x * x);
}
inline float approximate_albedo(const SheenBrdf& brdf, const glm::vec3& wo) {
  return detail::mean(diffuse_albedo(brdf, wo.z));
}

// Directions: uniform, as [1] has them. The cosine would leave out the horizon, where the light is.

inline glm::vec3 sample_lobe(const SheenBrdf&, const glm::vec3&, const glm::vec2& u) {
  const float z = 1.0F - u.x, sine = std::sqrt(u.x * (1.0F + z)), phi = 2.0F * float(kPi) * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}
template <class T>
ZONAL_INLINE inline T lobe_pdf(const SheenBrdf&, const glm::vec<3, T>&, const glm::vec3&) {
  return T(0.5L / kPi);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
