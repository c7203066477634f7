// Materials: sums of lobes, each of one model.
//
// Directions are unit vectors in the local frame, z being the surface normal; wi points towards the light, wo
// towards the eye. What a model is, and how to add one: model.hpp. The models stand in a file each: lambert.hpp,
// phong.hpp, ggx.hpp, residual.hpp, measured.hpp; those of others come in by custom.hpp. Here they are only forwarded
// to.
//
// Each kernel is a template on its scalar T (float, double, long double, or a packet of them); the parameters of
// a model are floats, and are widened, so that a projection done in double is limited by the model and not by its
// evaluation. What has no packet form, Phong, measured materials and custom ones, is evaluated lane by lane.
#pragma once

#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "custom.hpp"
#include "ggx.hpp"
#include "ggx_gaussian.hpp"
#include "lambert.hpp"
#include "measured.hpp"
#include "phong.hpp"
#include "residual.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

using BrdfLobe = std::variant<LambertBrdf, PhongBrdf, GgxBrdf, MeasuredBrdf, ResidualBrdf, CustomBrdf>;

/// A material: the sum of its lobes. Nothing checks that the sum conserves energy: Lambert beside GGX does not, where
/// energy.hpp has a material that does.
struct Brdf {
  std::vector<BrdfLobe> lobes;
};

// ---- Lobes: forwarded to their models -------------------------------------------------------------------------------

template <class T>
glm::vec<3, T> evaluate(const BrdfLobe& lobe, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  return std::visit([&](const auto& model) { return evaluate(model, wi, wo); }, lobe);
}
inline float approximate_albedo(const BrdfLobe& lobe, const glm::vec3& wo) {
  return std::visit([&](const auto& model) { return approximate_albedo(model, wo); }, lobe);
}
inline glm::vec3 sample_lobe(const BrdfLobe& lobe, const glm::vec3& wo, const glm::vec2& u) {
  return std::visit([&](const auto& model) { return sample_lobe(model, wo, u); }, lobe);
}
template <class T>
ZONAL_INLINE inline T lobe_pdf(const BrdfLobe& lobe, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  return std::visit([&](const auto& model) { return lobe_pdf(model, wi, wo); }, lobe);
}
inline glm::vec3 diffuse_albedo(const BrdfLobe& lobe, float cos_outgoing) {
  return std::visit([&](const auto& model) { return diffuse_albedo(model, cos_outgoing); }, lobe);
}
inline glm::vec3 glossy_albedo(const BrdfLobe& lobe, float cos_outgoing) {
  return std::visit([&](const auto& model) { return glossy_albedo(model, cos_outgoing); }, lobe);
}
inline GlossyLobe glossy_lobe(const BrdfLobe& lobe, float cos_outgoing) {
  return std::visit([&](const auto& model) { return glossy_lobe(model, cos_outgoing); }, lobe);
}
inline GlossyGaussian glossy_gaussian(const BrdfLobe& lobe, const glm::vec3& wo) {
  return std::visit([&](const auto& model) { return glossy_gaussian(model, wo); }, lobe);
}
template <class T>
ZONAL_INLINE inline glm::vec<3, T> gaussian_reflection(const BrdfLobe& lobe, const glm::vec<3, T>& axis,
                                                       const T& sharpness, const glm::vec3& wo) {
  return std::visit([&](const auto& model) ZONAL_INLINE { return gaussian_reflection(model, axis, sharpness, wo); },
                    lobe);
}
/// A lobe that looks nearly the same from everywhere: Lambert's, and what another lobe leaves.
inline bool is_diffuse(const BrdfLobe& lobe) {
  return std::visit([](const auto& model) { return is_diffuse(model); }, lobe);
}
inline bool is_isotropic(const BrdfLobe& lobe) {
  return std::visit([](const auto& model) { return is_isotropic(model); }, lobe);
}

// ---- Materials ------------------------------------------------------------------------------------------------------

/// The BRDF, RGB in 1/sr. wi, wo: unit vectors in the local frame; zero when either has z <= 0.
template <class T>
glm::vec<3, T> evaluate(const Brdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  glm::vec<3, T> sum(T(0));
  for (const BrdfLobe& lobe : brdf.lobes) sum = sum + evaluate(lobe, wi, wo);
  return sum;
}

/// Does the material look the same however it is turned about its normal?
inline bool is_isotropic(const Brdf& brdf) {
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (!is_isotropic(lobe)) return false;
  }
  return true;
}

/// The sum of a material's Lambert lobes' albedos.
inline glm::vec3 diffuse_albedo(const Brdf& brdf) {
  glm::vec3 sum(0.0F);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (const auto* lambert = std::get_if<LambertBrdf>(&lobe)) sum += lambert->albedo;
  }
  return sum;
}

/// The albedo of all lobes of is_diffuse, seen from cos_outgoing in [0, 1].
inline glm::vec3 diffuse_albedo(const Brdf& brdf, float cos_outgoing) {
  glm::vec3 sum(0.0F);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (is_diffuse(lobe)) sum += diffuse_albedo(lobe, cos_outgoing);
  }
  return sum;
}

/// A material's lobes other than Lambert's.
inline Brdf glossy_part(const Brdf& brdf) {
  Brdf glossy;
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (!std::holds_alternative<LambertBrdf>(lobe)) glossy.lobes.push_back(lobe);
  }
  return glossy;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
