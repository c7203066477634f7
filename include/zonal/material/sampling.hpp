// Random directions in proportion to a BRDF, for path tracers and light tracers.
//
// Same frame and directions as zonal/material/brdf.hpp. The caller brings the random numbers.
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
    const float weight = approximate_albedo(lobe, wo);
    if (weight <= 0.0F) continue;
    sum = sum + T(weight) * lobe_pdf(lobe, wi, wo);
    total += weight;
  }
  if (total <= 0.0F) return T(0);
  return select(detail::above_horizon(wi, glm::vec<3, T>(wo)), sum * T(1.0F / total), T(0));
}

/// A random direction towards the light. u_lobe in [0, 1) chooses the lobe, in proportion to its approximate
/// albedo; u in [0, 1)^2 the direction: cosine-weighted for Lambert and what other lobes leave, cos^n about the mirror
/// direction for Phong, by visible normals for GGX, as each model says.
inline BrdfSample sample(const Brdf& brdf, const glm::vec3& wo, float u_lobe, glm::vec2 u) {
  const BrdfLobe* lobe = wo.z > 0.0F ? detail::choose_lobe(brdf, wo, u_lobe) : nullptr;
  if (lobe == nullptr) return {glm::vec3(0.0F, 0.0F, 1.0F), 0.0F};
  const glm::vec3 direction = sample_lobe(*lobe, wo, u);
  return {direction, pdf(brdf, direction, wo)};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
