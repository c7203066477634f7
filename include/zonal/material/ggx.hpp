// Microfacets.
//
// [1] B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet Models for Refraction through Rough Surfaces",
//     EGSR 2007.
// [2] E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014.
// [3] E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
#pragma once

#include <algorithm>
#include <cmath>

#include "fresnel.hpp"
#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Isotropic GGX microfacets [1] with the height-correlated Smith masking-shadowing function [2] and single
/// scattering, which loses up to 69 % of the energy at roughness 1; energy.hpp has the rest. roughness is GGX's alpha
/// itself (no squaring), 0.001 to 1; below 1e-4 it counts as that, above 1 as 1.
struct GgxBrdf {
  float roughness;
  Fresnel fresnel;
};

namespace detail {

/// The half vector of two directions: its squared length before normalisation, |wi + wo|^2, and the squared sine and
/// cosine of its angle to the normal. The sine comes from its own components, not from 1 - cos^2: GGX at a small
/// roughness divides by it. Two opposite directions have none; it is then the normal, of length 0.
template <class T>
struct HalfVector {
  T squared_length, squared_sine, squared_cosine;
};

template <class T>
ZONAL_INLINE inline HalfVector<T> half_vector(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const glm::vec<3, T> h = wi + wo;
  // no underflow between two grazing directions, and no 0 / 0 between two opposite ones
  const T scale = maximum(maximum(maximum(abs(h.x), abs(h.y)), abs(h.z)), T(1e-37));
  const glm::vec<3, T> s = h * (T(1) / scale);
  const T across = s.x * s.x + s.y * s.y, along = maximum(s.z * s.z, T(1e-30));
  const T inverse = T(1) / (across + along);
  return {scale * scale * (across + along), across * inverse, along * inverse};
}

/// The roughness of a GGX lobe as its kernels take it: within what they give finite values for.
inline float ggx_alpha(float roughness) { return clamp(roughness, 1e-4F, 1.0F); }

/// D of [1] Eq. 33, in 1/sr: alpha^2 / (pi (cos^2 (alpha^2 - 1) + 1)^2), without its cancellation.
template <class T>
ZONAL_INLINE inline T ggx_distribution(const HalfVector<T>& h, T alpha) {
  const T width = h.squared_sine / alpha + alpha * h.squared_cosine;
  return T(1) / (T(kPi) * width * width);
}

/// cos sqrt(1 + alpha^2 tan^2): Smith's Lambda of [2] Eq. 72 is (this / cos - 1) / 2. Finite at the horizon.
template <class T>
ZONAL_INLINE inline T ggx_projected_length(T cos_angle, T alpha) {
  return sqrt(alpha * alpha * (T(1) - cos_angle * cos_angle) + cos_angle * cos_angle);
}

/// G2(wi, wo) / (4 cos_i cos_o) with the height-correlated G2 of [2] Eq. 99; the cosines cancel. The true
/// value diverges when both directions graze; it is held at 5e16, which only cosines below 1e-15 can reach.
template <class T>
ZONAL_INLINE inline T ggx_visibility(T cos_i, T cos_o, T alpha) {
  const T sum = cos_o * ggx_projected_length(cos_i, alpha) + cos_i * ggx_projected_length(cos_o, alpha);
  return T(0.5) / maximum(sum, T(1e-17));
}

/// A normal of the microfacets seen from wo, [3] appendix A.
template <class T>
glm::vec<3, T> sample_visible_normal(T alpha, const glm::vec<3, T>& wo, const glm::vec<2, T>& u) {
  using Vec3 = glm::vec<3, T>;
  const Vec3 view = glm::normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
  const T squared_sine = view.x * view.x + view.y * view.y;
  const Vec3 t1 = squared_sine > T(0) ? Vec3(-view.y, view.x, T(0)) / std::sqrt(squared_sine) : Vec3(T(1), T(0), T(0));
  const Vec3 t2 = glm::cross(view, t1);
  const T radius = std::sqrt(u.x), phi = T(2) * T(kPi) * u.y;
  const T p1 = radius * std::cos(phi);
  const T blend = T(0.5) * (T(1) + view.z);
  const T p2 = (T(1) - blend) * std::sqrt((std::max)(T(0), T(1) - p1 * p1)) + blend * radius * std::sin(phi);
  const Vec3 n = p1 * t1 + p2 * t2 + std::sqrt((std::max)(T(0), T(1) - p1 * p1 - p2 * p2)) * view;
  return glm::normalize(Vec3(alpha * n.x, alpha * n.y, (std::max)(T(1e-6), n.z)));
}

/// The half vector turns by half of what the incoming direction turns in the plane of incidence, and by 1 / (2 cos) of
/// it across: D = exp(-sin^2 / alpha^2) becomes an ASG.
inline GlossyLobe mirror_lobe(float roughness, float cos_outgoing) {
  const float alpha = ggx_alpha(roughness), cosine = (std::max)(cos_outgoing, 1e-3F);
  const float in_plane = 0.25F / (alpha * alpha);
  return {in_plane, in_plane / (cosine * cosine)};
}

}  // namespace detail

/// [1] Eq. 20 with the height-correlated G2 of [2] Eq. 99.
template <class T>
glm::vec<3, T> evaluate(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const T alpha = T(detail::ggx_alpha(brdf.roughness));
  const auto h = detail::half_vector(wi, wo);
  const T cos_difference = T(0.5) * sqrt(h.squared_length);  // wi . h = |wi + wo| / 2 for unit vectors
  const glm::vec<3, T> value = reflectance(brdf.fresnel, cos_difference) *
                               (detail::ggx_distribution(h, alpha) * detail::ggx_visibility(wi.z, wo.z, alpha));
  return detail::or_black<T>(detail::above_horizon(wi, wo), value);
}

inline float approximate_albedo(const GgxBrdf& brdf, const glm::vec3& wo) {
  return detail::mean(reflectance(brdf.fresnel, wo.z));
}

inline glm::vec3 sample_lobe(const GgxBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const glm::vec3 h = detail::sample_visible_normal(detail::ggx_alpha(brdf.roughness), wo, u);
  return 2.0F * glm::dot(wo, h) * h - wo;
}

/// [3] Eq. 17, G1 D / (4 cos_o), with cos_o cancelled.
template <class T>
ZONAL_INLINE inline T lobe_pdf(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const float alpha = detail::ggx_alpha(brdf.roughness);
  const T distribution = detail::ggx_distribution(detail::half_vector(wi, glm::vec<3, T>(wo)), T(alpha));
  return distribution * T(0.5F / (std::max)(wo.z + detail::ggx_projected_length(wo.z, alpha), 1e-30F));
}

inline glm::vec3 diffuse_albedo(const GgxBrdf&, float) { return glm::vec3(0.0F); }
inline glm::vec3 glossy_albedo(const GgxBrdf& brdf, float cos_outgoing) {
  return reflectance(brdf.fresnel, cos_outgoing);
}
inline GlossyLobe glossy_lobe(const GgxBrdf& brdf, float cos_outgoing) {
  return detail::mirror_lobe(brdf.roughness, cos_outgoing);
}

template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const T alpha = T(detail::ggx_alpha(brdf.roughness)), cosine = maximum(wi.z, T(0));
  const T cos_difference = T(0.5L) * sqrt(detail::half_vector(wi, glm::vec<3, T>(wo)).squared_length);
  const T height = detail::ggx_visibility(cosine, T(wo.z), alpha) * cosine / (T(kPi) * alpha * alpha);
  return reflectance(brdf.fresnel, cos_difference) * height;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
