#pragma once

#include <vector>

#include <zonal/gather/virtual_light.hpp>
#include <zonal/material/material_table.hpp>

#include "options.hpp"
#include "ray_caster.hpp"
#include "scene.hpp"

namespace hvl_render {

/// Every material of a scene, projected.
std::vector<zonal::MaterialTable> project_materials(const std::vector<Material>& materials,
                                                    const Options& options);

/// The side of the square map that holds at least `lights`.
int map_side(int lights);

/// One virtual light where each ray of the spotlight's map lands, with its radius set. Rays that find no
/// surface, or carry no light, leave none.
std::vector<zonal::VirtualLight> shoot_virtual_lights(const Scene& scene, const RayCaster& caster,
                                                      const std::vector<zonal::MaterialTable>& tables,
                                                      const Options& options);

}  // namespace hvl_render
