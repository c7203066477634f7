#include "materials.hpp"

#include <variant>

namespace example {

zonal::Brdf with_multiple_scattering(const zonal::Brdf& brdf) {
  const auto* ggx = brdf.lobes.size() == 1 ? std::get_if<zonal::GgxBrdf>(&brdf.lobes[0]) : nullptr;
  return ggx == nullptr ? brdf : zonal::with_multiple_scattering(*ggx);
}

BodyAndRest body_and_rest(const zonal::Brdf& brdf) {
  BodyAndRest parts;
  for (const zonal::BrdfLobe& lobe : brdf.lobes) (is_diffuse(lobe) ? parts.body : parts.rest).lobes.push_back(lobe);
  return parts;
}

}  // namespace example
