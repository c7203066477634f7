#include "materials.hpp"

#include <variant>

namespace example {

zonal::Brdf with_multiple_scattering(const zonal::Brdf& brdf) {
  const auto* ggx = brdf.lobes.size() == 1 ? std::get_if<zonal::GgxBrdf>(&brdf.lobes[0]) : nullptr;
  return ggx == nullptr ? brdf : zonal::with_multiple_scattering(*ggx);
}

}  // namespace example
