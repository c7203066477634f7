// A few materials by name, for programs, demonstrations and measurements. Roughness is GGX's alpha.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "brdf.hpp"
#include "energy.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

inline Brdf matte(const glm::vec3& albedo) { return {{LambertBrdf{albedo}}}; }

/// A diffuse body under a coat of refractive index 1.5; they share the light, and never reflect more than all.
inline Brdf plastic(const glm::vec3& albedo, float roughness) {
  return coated({roughness, DielectricFresnel{1.5F}}, albedo);
}

/// A metal by the refractive index of its RGB primaries.
struct Metal {
  const char* name;
  ConductorFresnel fresnel;
};

inline const std::vector<Metal>& metals() {
  static const std::vector<Metal> list{
      {"gold", {{0.143F, 0.375F, 1.442F}, {3.983F, 2.386F, 1.603F}}},
      {"silver", {{0.155F, 0.117F, 0.138F}, {4.828F, 3.122F, 2.147F}}},
      {"copper", {{0.200F, 0.924F, 1.102F}, {3.912F, 2.452F, 2.142F}}},
      {"aluminium", {{1.657F, 0.880F, 0.521F}, {9.224F, 6.270F, 4.837F}}},
      {"iron", {{2.911F, 2.950F, 2.585F}, {3.089F, 2.932F, 2.767F}}},
  };
  return list;
}

/// Null for a name that metals() does not have.
inline const Metal* find_metal(const std::string& name) {
  const auto found =
      std::find_if(metals().begin(), metals().end(), [&](const Metal& metal) { return metal.name == name; });
  return found == metals().end() ? nullptr : &*found;
}

inline Brdf metal(const Metal& metal, float roughness) { return {{GgxBrdf{roughness, metal.fresnel}}}; }

}  // namespace ZONAL_TARGET
}  // namespace zonal
