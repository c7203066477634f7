#pragma once

#include <vector>

#include <zonal/gather/virtual_light.hpp>
#include <zonal/material/material_table.hpp>

#include "options.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

/// A scene's materials, projected: windowed for the bands with which a receiver reads them, and for those of
/// a virtual light's emission.
struct MaterialTables {
  std::vector<zonal::MaterialTable> receiving;
  std::vector<zonal::MaterialTable> emitting;
  double error = 0.0;  // greatest of the projections, of each table's largest coefficient
};

MaterialTables project_materials(const std::vector<Material>& materials, const Options& options);

/// The side of the square map that holds at least `lights`.
int map_side(int lights);

/// One virtual light where each ray of the spotlight's map lands, with its radius set. Rays that find no
/// surface, or carry no light, leave none.
std::vector<zonal::VirtualLight> shoot_virtual_lights(const Scene& scene, const RayCaster& caster,
                                                      const std::vector<zonal::MaterialTable>& tables,
                                                      const Options& options);

}  // namespace example::hvl_render
