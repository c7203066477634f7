#pragma once

#include <algorithm>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <zonal/basis/sh.hpp>
#include <zonal/material/material_table.hpp>

#include "options.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::grid_render {

/// A glossy lobe as a zonal kernel about the mirrored view direction, times an albedo.
///
/// The kernel is the lobe as seen from the normal, BRDF times cosine with a Fresnel reflectance of 1, divided by its
/// integral: a split sum, which forgets that lobes stretch towards the horizon and that the horizon cuts them. The
/// albedo, by the view's angle and with the true Fresnel reflectance, puts the energy right. A light of half angle 30
/// degrees, mirrored by gold of roughness 0.5 at 40 degrees, is 11 % off.
struct GlossyLobe {
  zonal::Zh<most_lobe_bands, float> kernel;          // integrates to 1; zero from --lobe-bands on
  zonal::Zh<most_lobe_bands, float> without_cosine;  // the same BRDF alone, divided by the same integral
  zonal::MaterialTable albedo;                       // one band
};

/// A material as convolutions: with the clamped cosine about the normal, and with each glossy lobe.
struct Reflector {
  glm::vec3 diffuse_albedo{0.0f};
  std::vector<GlossyLobe> glossy;
};

/// As many bands of a lobe as the light has.
template <int N>
zonal::Zh<N, float> first_bands(const zonal::Zh<most_lobe_bands, float>& lobe) {
  zonal::Zh<N, float> bands{};
  std::copy_n(lobe.begin(), std::min(N, most_lobe_bands), bands.begin());
  return bands;
}

/// The sum over a material's lobes: diffuse(normal) is the light that meets the clamped cosine over pi, glossy(lobe,
/// mirrored) that which meets a lobe about the mirrored view direction.
template <class Diffuse, class Glossy>
glm::vec3 sum_of_lobes(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector, const Diffuse& diffuse,
                       const Glossy& glossy) {
  glm::vec3 sum(0.0f);
  if (reflector.diffuse_albedo != glm::vec3(0.0f)) sum = reflector.diffuse_albedo * hit.colour * diffuse(hit.normal);
  const float cos_outgoing = glm::dot(hit.normal, outgoing);
  for (const GlossyLobe& lobe : reflector.glossy) {
    const glm::vec3 mirrored = glm::normalize(2.0f * cos_outgoing * hit.normal - outgoing);
    // The integral of BRDF times cosine, sqrt(4 pi) times its first coefficient.
    const glm::vec3 albedo = lobe.albedo.with_cosine<1>(cos_outgoing)[0] * (2.0f * glm::root_pi<float>());
    sum += albedo * glossy(lobe, mirrored);
  }
  return sum;
}

std::vector<Reflector> project_materials(const std::vector<Material>& materials, const Options& options);

}  // namespace example::grid_render
