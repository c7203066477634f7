// Measured materials, or any other function, as a lobe among the models of brdf.hpp.
//
//   zonal::Brdf material{{zonal::measured(zonal::load_merl("gold-metallic-paint.binary"))}};
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "../scalar/function_ref.hpp"
#include "brdf_projection.hpp"
#include "even_part.hpp"
#include "ggx.hpp"
#include "ggx_gaussian.hpp"
#include "lambert.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A quadrature over the hemisphere that suits a BRDF seen from wo: nodes(wo, level, visit) calls visit(wi, f(wi, wo)
/// times the node's solid angle), level 0 to brdf_node_levels - 1 from coarse to fine. An isotropic BRDF's are for
/// integrals with functions of wi that are even about the plane of wo.
using BrdfNodes = SharedFunction<void(const glm::dvec3& wo, int level,
                                      const FunctionRef<void(const glm::dvec3& wi, const glm::dvec3& weighted)>&)>;
inline constexpr int brdf_node_levels = 4;

/// A measured material; measured(f), below, makes it. The function is the material; beside it stand a diffuse and a GGX
/// lobe of about its size, to choose directions by, and for virtual lights that are Gaussians; and its own quadrature,
/// for projections, where it has one. It need not be reciprocal: f(wi, wo), where wo is the direction the light leaves
/// in, may differ from f(wo, wi).
struct MeasuredBrdf {
  BrdfFunction function;
  glm::vec3 diffuse_albedo, specular_albedo;
  float roughness;
  BrdfNodes nodes{};
  bool isotropic = true;  // else it is to be asked in the surface's own frame: directions with x along its tangent
};

namespace detail {

/// The diffuse and the GGX lobe that stand beside a measured material, in proportion to their albedos.
struct MeasuredProposal {
  float diffuse_share;
  GgxBrdf specular;

  explicit MeasuredProposal(const MeasuredBrdf& brdf)
      : diffuse_share(mean(brdf.diffuse_albedo) / (mean(brdf.diffuse_albedo) + mean(brdf.specular_albedo))),
        specular{brdf.roughness, SchlickFresnel{glm::vec3(1.0F)}} {}
};

}  // namespace detail

template <class T>
glm::vec<3, T> evaluate(const MeasuredBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return glm::vec<3, T>(brdf.function(glm::dvec3(wi), glm::dvec3(wo)));
  } else {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  }
}

inline float approximate_albedo(const MeasuredBrdf& brdf, const glm::vec3&) {
  return detail::mean(brdf.diffuse_albedo) + detail::mean(brdf.specular_albedo);
}

inline glm::vec3 sample_lobe(const MeasuredBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const detail::MeasuredProposal proposal(brdf);
  const float share = proposal.diffuse_share;
  if (u.x < share) return sample_lobe(LambertBrdf{}, wo, {u.x / share, u.y});
  return sample_lobe(proposal.specular, wo, {(std::min)((u.x - share) / (1.0F - share), 0x1.fffffep-1F), u.y});
}

template <class T>
ZONAL_INLINE inline T lobe_pdf(const MeasuredBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const detail::MeasuredProposal proposal(brdf);
  const T share = T(proposal.diffuse_share);
  return share * lobe_pdf(LambertBrdf{}, wi, wo) + (T(1) - share) * lobe_pdf(proposal.specular, wi, wo);
}

inline bool is_isotropic(const MeasuredBrdf& brdf) { return brdf.isotropic; }
inline glm::vec3 diffuse_albedo(const MeasuredBrdf& brdf, float) { return brdf.diffuse_albedo; }
inline glm::vec3 glossy_albedo(const MeasuredBrdf& brdf, float) { return brdf.specular_albedo; }
inline GlossyLobe glossy_lobe(const MeasuredBrdf& brdf, float cos_outgoing) {
  return detail::mirror_lobe(brdf.roughness, cos_outgoing);
}

template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const MeasuredBrdf& brdf, const glm::vec<3, T>&, const glm::vec3& wo) {
  return glm::vec<3, T>(brdf.specular_albedo * (0.5F * glossy_lobe(brdf, wo.z).sharpness() / float(kPi)));
}

inline GlossyGaussian glossy_gaussian(const MeasuredBrdf& brdf, const glm::vec3& wo) {
  return detail::ggx_gaussian(detail::ggx_alpha(brdf.roughness), wo);
}

/// The share of a GGX lobe's reflection, for the lobe beside a measured material reflects its albedo.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> gaussian_reflection(const MeasuredBrdf& brdf, const glm::vec<3, T>& axis,
                                                       const T& sharpness, const glm::vec3& wo) {
  const float alpha = detail::ggx_alpha(brdf.roughness);
  const float whole = detail::ggx_reflection(alpha, glm::vec3(0.0F, 0.0F, 1.0F), 0.0F, wo).amount;
  return glm::vec<3, T>(brdf.specular_albedo / whole) * detail::ggx_reflection(alpha, axis, sharpness, wo).amount;
}

namespace detail {

/// A function's value f cos at a node of a quadrature over the hemisphere, and what it takes to weigh densities by it.
struct MeasuredNode {
  glm::vec3 wi, wo;
  glm::dvec3 reflected;  // f cos, 1/sr
  double solid_angle;    // of the node
};

/// The midpoint rule over half vectors, whose angle to the normal is (pi/2) s^2: nodes crowd at the mirror direction.
inline std::vector<MeasuredNode> measured_nodes(const BrdfFunction& brdf, double azimuth) {
  constexpr int rings = 48, spokes = 24;
  constexpr double right_angle = 0.5 * double(kPi);
  std::vector<MeasuredNode> nodes;
  for (const double degrees : {10.0, 40.0, 70.0}) {
    const double theta_o = degrees / 90.0 * right_angle;
    const glm::dvec3 wo(std::sin(theta_o) * std::cos(azimuth), std::sin(theta_o) * std::sin(azimuth),
                        std::cos(theta_o));
    for (int ring = 0; ring < rings; ++ring) {
      const double s = (ring + 0.5) / rings, theta = right_angle * s * s, ring_width = 2.0 * right_angle * s / rings;
      for (int spoke = 0; spoke < spokes; ++spoke) {
        const double phi = 2.0 * double(kPi) * (spoke + 0.5) / spokes;
        const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        const double cos_difference = glm::dot(h, wo);
        const glm::dvec3 wi = 2.0 * cos_difference * h - wo;
        if (cos_difference <= 0.0 || wi.z <= 0.0) continue;
        const double solid_angle = 4.0 * cos_difference * std::sin(theta) * ring_width * (2.0 * double(kPi) / spokes);
        nodes.push_back({glm::vec3(wi), glm::vec3(wo), brdf(wi, wo) * wi.z, solid_angle});
      }
    }
  }
  return nodes;
}

/// How badly a mixture of the two lobes samples the nodes: the second moment of the estimate, channels added.
inline double second_moment(const std::vector<MeasuredNode>& nodes, float diffuse_share, float roughness) {
  const GgxBrdf specular{roughness, SchlickFresnel{glm::vec3(1.0F)}};
  double sum = 0.0;
  for (const MeasuredNode& node : nodes) {
    const float density = diffuse_share * lobe_pdf(LambertBrdf{}, node.wi, node.wo) +
                          (1.0F - diffuse_share) * lobe_pdf(specular, node.wi, node.wo);
    const double value = node.reflected.x + node.reflected.y + node.reflected.z;
    sum += value * value / double(density) * node.solid_angle;
  }
  return sum;
}

/// Has F a quadrature of its own?
template <class F, class = void>
inline constexpr bool has_nodes = false;
template <class F>
inline constexpr bool
    has_nodes<F, std::void_t<decltype(std::declval<const F&>().for_each_node(
                     glm::dvec3(), 0, std::declval<void (*)(const glm::dvec3&, const glm::dvec3&)>()))>> = true;

/// Does F say whether it is isotropic?
template <class F, class = void>
inline constexpr bool has_isotropic = false;
template <class F>
inline constexpr bool has_isotropic<F, std::void_t<decltype(bool(std::declval<const F&>().isotropic()))>> = true;

}  // namespace detail

/// Wraps a BRDF, a callable (glm::dvec3 wi, glm::dvec3 wo) -> glm::dvec3 in 1/sr, as a lobe. It counts as isotropic,
/// unless F has a member isotropic() that says no; of an isotropic one the lobe is the part that is even in phi, so
/// that all that is made of it, projections and paths, sees one material. The lobes beside it are those that sample it
/// with the least variance, of 24 roughnesses from 0.02 to 1 and 9 mixtures; takes 0.1 s. Where F has a for_each_node
/// as RglBrdf has, projections integrate by it.
template <class F>
MeasuredBrdf measured(F brdf) {
  const auto shared = std::make_shared<const F>(std::move(brdf));
  MeasuredBrdf result{{}, {}, {}, 1.0F};
  if constexpr (detail::has_isotropic<F>) result.isotropic = shared->isotropic();
  const bool isotropic = result.isotropic;
  result.function = [shared, isotropic](const glm::dvec3& wi, const glm::dvec3& wo) {
    return isotropic ? even_part(*shared)(wi, wo) : (*shared)(wi, wo);
  };
  if constexpr (detail::has_nodes<F>) {
    result.nodes = [shared](const glm::dvec3& wo, int level, const auto& visit) {
      shared->for_each_node(wo, level, visit);
    };
  }
  std::vector<detail::MeasuredNode> nodes = detail::measured_nodes(result.function, 0.0);
  if (!isotropic) {
    for (const double azimuth : {0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6}) {
      const std::vector<detail::MeasuredNode> more = detail::measured_nodes(result.function, azimuth);
      nodes.insert(nodes.end(), more.begin(), more.end());
    }
  }
  const double directions = isotropic ? 3.0 : 24.0;
  glm::dvec3 albedo(0.0);  // mean over the outgoing directions
  for (const detail::MeasuredNode& node : nodes) albedo += node.reflected * node.solid_angle / directions;

  float best_share = 1.0F;
  double least = std::numeric_limits<double>::infinity();
  for (int r = 0; r < 24; ++r) {
    const float roughness = std::pow(0.02F, 1.0F - float(r) / 23.0F);
    for (int s = 1; s < 10; ++s) {
      const double moment = detail::second_moment(nodes, 0.1F * float(s), roughness);
      if (!(moment < least)) continue;
      least = moment;
      best_share = 0.1F * float(s);
      result.roughness = roughness;
    }
  }
  result.diffuse_albedo = glm::vec3(albedo) * best_share;
  result.specular_albedo = glm::vec3(albedo) * (1.0F - best_share);
  return result;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
