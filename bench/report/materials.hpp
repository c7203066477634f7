// The materials of the report.
#pragma once

#include <string>
#include <vector>

#include <zonal/material/named.hpp>

namespace zonal_report {

/// `source`: model, MERL or RGL.
struct NamedMaterial {
  std::string name, source;
  zonal::Brdf brdf;
};

using zonal::matte;
using zonal::plastic;

/// GGX that reflects all that meets a facet.
zonal::Brdf white_ggx(float roughness);
zonal::Brdf gold(float roughness);

/// Models, and what lies in the folders merl and rgl of $ZONAL_DATA.
std::vector<NamedMaterial> all_materials();

}  // namespace zonal_report
