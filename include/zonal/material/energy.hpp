// Materials that keep the energy: a diffuse body under a GGX coat, and GGX whose light bounces between microfacets.
//
// A GGX lobe of albedo E(wo) leaves 1 - E. A Lambert lobe beside it would reflect its share of all the light, and the
// two of them up to a third too much at grazing angles. Here a body reflects its share of what the coat leaves [1]:
//
//   f_body = albedo (1 - E(wi)) (1 - E(wo)) / (pi (1 - E_mean)),   E_mean = 2 integral of E(cos) cos dcos
//
// which is reciprocal and reflects albedo (1 - E(wo)). The same lobe gives back what single scattering loses between
// microfacets, up to 69 % [2]: there E is the albedo of a white GGX, and, with F the mean Fresnel reflectance, the k-th
// further bounce reflects F^(k+1) of it, of which the share E_mean leaves:
//
//   albedo = F^2 E_mean / (1 - F (1 - E_mean))
//
// E is a polynomial (ResidualBrdf), fitted when the material is made, in some 10 ms; it evaluates in packets.
//
// [1] C. Kelemen, L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model with Importance Sampling",
//     Eurographics 2001 short presentations.
// [2] C. Kulla, A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017 course.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "../scalar/quadrature.hpp"
#include "sampling.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a GGX lobe reflects of uniform light, RGB, seen at cos_outgoing in (0, 1]. Greatest error: 3e-4.
///
/// The directions are those of sample_lobe, which leave of the integrand only Fresnel's term and the masking: smooth,
/// but for a kink where directions reach the horizon. Halves of the circle are alike.
inline glm::dvec3 ggx_albedo(const GgxBrdf& lobe, double cos_outgoing) {
  constexpr int rings = 64, spokes = 24;
  static const QuadratureRule rule = gauss_legendre(rings);
  const double alpha = double(detail::ggx_alpha(lobe.roughness)), cos_o = std::clamp(cos_outgoing, 1e-9, 1.0);
  const glm::dvec3 wo(std::sqrt((1.0 - cos_o) * (1.0 + cos_o)), 0.0, cos_o);
  const double length_o = detail::ggx_projected_length(cos_o, alpha);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < rings; ++i) {
    const double x = 0.5 * (1.0 + rule.nodes[i]), u = x * x * (3.0 - 2.0 * x);  // nodes crowd at both ends
    const double weight = 6.0 * x * (1.0 - x) * 0.5 * rule.weights[i] / spokes;
    for (int j = 0; j < spokes; ++j) {
      const glm::dvec3 h = detail::sample_visible_normal(alpha, wo, {u, 0.5 * (j + 0.5) / spokes - 0.25});
      const double cos_difference = glm::dot(h, wo), cos_i = 2.0 * cos_difference * h.z - cos_o;
      if (cos_difference <= 0.0 || cos_i <= 0.0) continue;
      const double length_i = detail::ggx_projected_length(cos_i, alpha);
      const double masking = cos_i * (cos_o + length_o) / (cos_o * length_i + cos_i * length_o);  // G2 / G1
      sum += reflectance(lobe.fresnel, cos_difference) * (weight * masking);
    }
  }
  return sum;
}

namespace detail {

/// The cosine at which t of ResidualBrdf is 2 x - 1.
inline double residual_cosine(double scale, double x) {
  const double y = x * x / (1.0 + scale);
  return scale * y / (1.0 - y);
}

/// 2 integral of f(cos) cos dcos over [0, 1], for f smooth in x.
template <class F>
glm::dvec3 cosine_mean(double scale, const F& f) {
  static const QuadratureRule rule = gauss_legendre(64);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double x = 0.5 * (1.0 + rule.nodes[i]), y = x * x / (1.0 + scale);
    const double cosine = residual_cosine(scale, x);
    const double derivative = scale / ((1.0 - y) * (1.0 - y)) * 2.0 * x / (1.0 + scale);
    sum += f(cosine) * (2.0 * cosine * derivative * 0.5 * rule.weights[i]);
  }
  return sum;
}

/// The least of which the fit and the quadrature may be off: taken from what is left, so that never more than all is
/// reflected.
inline constexpr double residual_margin = 1e-3;

/// As a surface turns smooth, its albedo comes to bend in two places, at the cosine alpha and at that of Fresnel's
/// rise: of the scales tried, those that polynomials take best to.
inline float residual_scale(float roughness) { return std::sqrt((std::max)(ggx_alpha(roughness), 0.0225F)); }

}  // namespace detail

/// The lobe that reflects `albedo`, RGB in [0, 1], of what a GGX lobe leaves. Together they reflect at most all
/// (measured: 1.0001), and of albedo 1 all but 3e-3, below roughness 0.01 all but 2e-2.
inline ResidualBrdf residual(const GgxBrdf& lobe, const glm::vec3& albedo) {
  constexpr int size = ResidualBrdf::degree + 1;
  ResidualBrdf result{};
  result.albedo = albedo;
  result.scale = detail::residual_scale(lobe.roughness);
  const auto cosine_at = [&](double angle) {
    return detail::residual_cosine(double(result.scale), 0.5 * (1.0 + std::cos(angle)));
  };
  for (int i = 0; i < size; ++i) {
    const double angle = double(kPi) * (i + 0.5) / size;
    const glm::dvec3 left = 1.0 - ggx_albedo(lobe, cosine_at(angle));
    for (int k = 0; k < size; ++k) {
      result.chebyshev[k] += glm::vec3(left * (std::cos(k * angle) * (k > 0 ? 2.0 : 1.0) / size));
    }
  }
  // Between these places the polynomial is off by most.
  glm::dvec3 excess(0.0);
  for (int i = 0; i <= size; ++i) {
    const double cosine = cosine_at(double(kPi) * i / size);
    excess = (glm::max)(excess, ggx_albedo(lobe, cosine) + glm::dvec3(left_at(result, cosine)) - 1.0);
  }
  result.chebyshev[0] -= glm::vec3(excess + detail::residual_margin);
  result.mean =
      glm::vec3(detail::cosine_mean(double(result.scale), [&](double cosine) { return left_at(result, cosine); }));
  return result;
}

/// A diffuse body of this albedo under a GGX coat: a plastic, a lacquer, a varnish.
inline Brdf coated(const GgxBrdf& coat, const glm::vec3& body_albedo) { return {{coat, residual(coat, body_albedo)}}; }

/// A GGX lobe with the light that is scattered more than once between its microfacets: a white one reflects all, with
/// the errors of residual().
inline Brdf with_multiple_scattering(const GgxBrdf& lobe) {
  const GgxBrdf white{lobe.roughness, SchlickFresnel{glm::vec3(1.0F)}};
  ResidualBrdf bounces = residual(white, glm::vec3(1.0F));
  const glm::dvec3 fresnel = detail::cosine_mean(1.0, [&](double cosine) { return reflectance(lobe.fresnel, cosine); });
  const glm::dvec3 lost(bounces.mean);
  bounces.albedo = glm::vec3(fresnel * fresnel * (1.0 - lost) / (1.0 - fresnel * lost));
  return {{lobe, bounces}};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
