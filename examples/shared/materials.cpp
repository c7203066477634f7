#include "materials.hpp"

#include <algorithm>
#include <variant>

#include <zonal/material/energy.hpp>

namespace example {

zonal::Brdf matte(const glm::vec3& albedo) { return {{zonal::LambertBrdf{albedo}}}; }

zonal::Brdf plastic(const glm::vec3& albedo, float roughness) {
  return zonal::coated({roughness, zonal::DielectricFresnel{1.5f}}, albedo);
}

zonal::Brdf metal(const Metal& metal, float roughness) { return {{zonal::GgxBrdf{roughness, metal.fresnel}}}; }

zonal::Brdf with_multiple_scattering(const zonal::Brdf& brdf) {
  const auto* ggx = brdf.lobes.size() == 1 ? std::get_if<zonal::GgxBrdf>(&brdf.lobes[0]) : nullptr;
  return ggx == nullptr ? brdf : zonal::with_multiple_scattering(*ggx);
}

const std::vector<Metal>& metals() {
  static const std::vector<Metal> list{
      {"gold", {{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}}},
      {"silver", {{0.155f, 0.117f, 0.138f}, {4.828f, 3.122f, 2.147f}}},
      {"copper", {{0.200f, 0.924f, 1.102f}, {3.912f, 2.452f, 2.142f}}},
      {"aluminium", {{1.657f, 0.880f, 0.521f}, {9.224f, 6.270f, 4.837f}}},
      {"iron", {{2.911f, 2.950f, 2.585f}, {3.089f, 2.932f, 2.767f}}},
  };
  return list;
}

const Metal* find_metal(const std::string& name) {
  const auto found =
      std::find_if(metals().begin(), metals().end(), [&](const Metal& metal) { return metal.name == name; });
  return found == metals().end() ? nullptr : &*found;
}

}  // namespace example
