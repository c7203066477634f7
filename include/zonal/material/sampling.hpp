// Random directions in proportion to a BRDF, for path tracers and light tracers.
//
// Same frame and directions as zonal/material/brdf.hpp. The caller brings the random numbers.
//
// [1] E. Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018.
// [2] E. Lafortune, Y. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering",
//     report CW 197, KU Leuven, 1994.
// [3] J. R. Frisvad, "Building an Orthonormal Basis from a 3D Unit Vector Without Normalization", Journal of
//     Graphics Tools 16(3), 2012.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "brdf.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A direction towards the light, and the density (1/sr) with which the whole mixture of lobes gives it.
/// pdf 0 means no sample: the direction is below the horizon, or the material is black; count its light as
/// zero.
struct BrdfSample {
  glm::vec3 direction;
  float pdf;
};

namespace detail {

inline float mean(const glm::vec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3.0F; }

/// About the albedo of a lobe seen from wo, channels averaged: what to choose lobes by. It is positive
/// wherever the lobe is, which is all that correctness asks for.
inline float approximate_albedo(const LambertBrdf& brdf, const glm::vec3&) { return mean(brdf.albedo); }
inline float approximate_albedo(const PhongBrdf& brdf, const glm::vec3&) { return mean(brdf.specular_albedo); }
inline float approximate_albedo(const GgxBrdf& brdf, const glm::vec3& wo) {
  return mean(reflectance(brdf.fresnel, wo.z));
}
inline float approximate_albedo(const MeasuredBrdf& brdf, const glm::vec3&) {
  return mean(brdf.diffuse_albedo) + mean(brdf.specular_albedo);
}
inline float approximate_albedo(const ResidualBrdf& brdf, const glm::vec3& wo) {
  return mean(brdf.albedo * left_at(brdf, wo.z));
}
inline float approximate_albedo(const BrdfLobe& lobe, const glm::vec3& wo) {
  return std::visit([&](const auto& model) { return approximate_albedo(model, wo); }, lobe);
}

/// Cosine-weighted direction about z. u in [0, 1)^2.
inline glm::vec3 sample_lobe(const LambertBrdf&, const glm::vec3&, const glm::vec2& u) {
  const float radius = std::sqrt(u.x), phi = 2.0F * float(kPi) * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0F - u.x)};
}

template <class T>
ZONAL_INLINE inline T lobe_pdf(const LambertBrdf&, const glm::vec<3, T>& wi, const glm::vec3&) {
  return wi.z * T(1 / kPi);
}

/// The same: what is left varies little over the cosine.
inline glm::vec3 sample_lobe(const ResidualBrdf&, const glm::vec3& wo, const glm::vec2& u) {
  return sample_lobe(LambertBrdf{}, wo, u);
}

template <class T>
ZONAL_INLINE inline T lobe_pdf(const ResidualBrdf&, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  return lobe_pdf(LambertBrdf{}, wi, wo);
}

/// v, given in a frame whose z axis is `axis`, in the frame of `axis` [3]. axis.z >= 0 keeps clear of the
/// pole.
inline glm::vec3 rotate_z_to(const glm::vec3& axis, const glm::vec3& v) {
  const float a = 1.0F / (1.0F + axis.z), b = -axis.x * axis.y * a;
  const glm::vec3 x_axis(1.0F - axis.x * axis.x * a, b, -axis.x);
  const glm::vec3 y_axis(b, 1.0F - axis.y * axis.y * a, -axis.y);
  return v.x * x_axis + v.y * y_axis + v.z * axis;
}

/// [2]: cos = u^(1/(n+1)) about the mirror direction. 1 - cos is computed on its own, so that a high exponent
/// still has its directions apart.
inline glm::vec3 sample_lobe(const PhongBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const float one_minus_cos = -std::expm1(std::log(u.x) / (brdf.exponent + 1.0F));
  const float sine = std::sqrt(one_minus_cos * (2.0F - one_minus_cos)), phi = 2.0F * float(kPi) * u.y;
  const glm::vec3 mirror(-wo.x, -wo.y, wo.z);
  return rotate_z_to(mirror, {sine * std::cos(phi), sine * std::sin(phi), 1.0F - one_minus_cos});
}

template <class T>
T lobe_pdf(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return (T(brdf.exponent) + T(1)) / (T(2) * T(kPi)) * phong_lobe(wi, glm::vec<3, T>(wo), T(brdf.exponent));
  } else {
    const auto pdf = [&](const auto& i, const auto& o) { return glm::vec<3, lane_t<T>>(lobe_pdf(brdf, i, o)); };
    return by_lanes(wi, glm::vec<3, T>(wo), pdf).x;
  }
}

/// A normal of the microfacets seen from wo, [1] appendix A.
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

inline glm::vec3 sample_lobe(const GgxBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const glm::vec3 h = sample_visible_normal(ggx_alpha(brdf.roughness), wo, u);
  return 2.0F * glm::dot(wo, h) * h - wo;
}

/// [1] Eq. 17, G1 D / (4 cos_o), with cos_o cancelled.
template <class T>
ZONAL_INLINE inline T lobe_pdf(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const float alpha = ggx_alpha(brdf.roughness);
  const T distribution = ggx_distribution(half_vector(wi, glm::vec<3, T>(wo)), T(alpha));
  return distribution * T(0.5F / (std::max)(wo.z + ggx_projected_length(wo.z, alpha), 1e-30F));
}

/// The diffuse and the GGX lobe that stand beside a measured material, in proportion to their albedos.
struct MeasuredProposal {
  float diffuse_share;
  GgxBrdf specular;

  explicit MeasuredProposal(const MeasuredBrdf& brdf)
      : diffuse_share(mean(brdf.diffuse_albedo) / (mean(brdf.diffuse_albedo) + mean(brdf.specular_albedo))),
        specular{brdf.roughness, SchlickFresnel{glm::vec3(1.0F)}} {}
};

inline glm::vec3 sample_lobe(const MeasuredBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const MeasuredProposal proposal(brdf);
  const float share = proposal.diffuse_share;
  if (u.x < share) return sample_lobe(LambertBrdf{}, wo, {u.x / share, u.y});
  return sample_lobe(proposal.specular, wo, {(std::min)((u.x - share) / (1.0F - share), 0x1.fffffep-1F), u.y});
}

template <class T>
ZONAL_INLINE inline T lobe_pdf(const MeasuredBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const MeasuredProposal proposal(brdf);
  const T share = T(proposal.diffuse_share);
  return share * lobe_pdf(LambertBrdf{}, wi, wo) + (T(1) - share) * lobe_pdf(proposal.specular, wi, wo);
}

inline glm::vec3 sample_lobe(const BrdfLobe& lobe, const glm::vec3& wo, const glm::vec2& u) {
  return std::visit([&](const auto& model) { return sample_lobe(model, wo, u); }, lobe);
}

template <class T>
ZONAL_INLINE inline T lobe_pdf(const BrdfLobe& lobe, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  return std::visit([&](const auto& model) { return lobe_pdf(model, wi, wo); }, lobe);
}

/// The lobe at u_lobe of the way through the summed albedos; null when the material is black.
inline const BrdfLobe* choose_lobe(const Brdf& brdf, const glm::vec3& wo, float u_lobe) {
  float total = 0.0F;
  for (const BrdfLobe& lobe : brdf.lobes) total += approximate_albedo(lobe, wo);
  float remaining = u_lobe * total;
  const BrdfLobe* chosen = nullptr;
  for (const BrdfLobe& lobe : brdf.lobes) {
    const float weight = approximate_albedo(lobe, wo);
    if (weight <= 0.0F) continue;
    chosen = &lobe;  // the last one with a weight, should rounding leave something over
    if (remaining < weight) break;
    remaining -= weight;
  }
  return chosen;
}

}  // namespace detail

/// The density, in 1/sr, with which sample(brdf, wo, ...) returns wi: the lobes' densities weighted by their
/// albedos. Zero at or below the horizon; so it integrates to one minus the probability of no sample. T is float, or a
/// packet of directions wi.
template <class T>
T pdf(const Brdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  T sum = T(0);
  float total = 0.0F;
  for (const BrdfLobe& lobe : brdf.lobes) {
    const float weight = detail::approximate_albedo(lobe, wo);
    if (weight <= 0.0F) continue;
    sum = sum + T(weight) * detail::lobe_pdf(lobe, wi, wo);
    total += weight;
  }
  if (total <= 0.0F) return T(0);
  return select(detail::above_horizon(wi, glm::vec<3, T>(wo)), sum * T(1.0F / total), T(0));
}

/// A random direction towards the light. u_lobe in [0, 1) chooses the lobe, in proportion to its approximate
/// albedo; u in [0, 1)^2 the direction: cosine-weighted for Lambert and what other lobes leave, cos^n about the mirror
/// direction for Phong [2], by visible normals for GGX [1].
inline BrdfSample sample(const Brdf& brdf, const glm::vec3& wo, float u_lobe, glm::vec2 u) {
  const BrdfLobe* lobe = wo.z > 0.0F ? detail::choose_lobe(brdf, wo, u_lobe) : nullptr;
  if (lobe == nullptr) return {glm::vec3(0.0F, 0.0F, 1.0F), 0.0F};
  const glm::vec3 direction = detail::sample_lobe(*lobe, wo, u);
  return {direction, pdf(brdf, direction, wo)};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
