#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <zonal/material/brdf.hpp>

namespace example {

// The materials of the programs, and what they are made of. Roughness is GGX's alpha.

zonal::Brdf matte(const glm::vec3& albedo);

/// A diffuse body under a coat of refractive index 1.5; they share the light, and never reflect more than all.
zonal::Brdf plastic(const glm::vec3& albedo, float roughness);

/// A metal by the refractive index of its RGB primaries.
struct Metal {
  const char* name;
  zonal::ConductorFresnel fresnel;
};

const std::vector<Metal>& metals();

/// Null for a name that metals() does not have.
const Metal* find_metal(const std::string& name);

zonal::Brdf metal(const Metal& metal, float roughness);

/// The material with the light that bounces between its microfacets, where it is a GGX lobe alone. Under a coat the body
/// has that light already: it reflects of all that the coat leaves.
zonal::Brdf with_multiple_scattering(const zonal::Brdf& brdf);

}  // namespace example
