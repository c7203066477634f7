// What a program of several translation units shares: its own type, which holds one of the library's.
#pragma once

#include <vector>

#include <zonal/gather/hvl.hpp>
#include <zonal/material/material_table.hpp>

struct Scene {
  zonal::HvlCache<1> cache;
};

void build(Scene& scene);  // in build.cpp, compiled by other flags

namespace {
zonal::MaterialTable white() {
  return zonal::project_material(zonal::Brdf{{zonal::LambertBrdf{glm::vec3(0.5F)}}}, 3, 1e-2);
}

// 37 lights in a row: in no width are all packets full.
void build_here(Scene& scene) {
  const zonal::MaterialTable table = white();
  std::vector<zonal::VirtualLight> lights(37);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].position = {0.1F * float(i), 0.0F, 1.0F};
    lights[i].normal = lights[i].to_primary = {0.0F, 0.0F, -1.0F};
    lights[i].flux = glm::vec3(1.0F);
    lights[i].radius = 0.1F;
    lights[i].material = &table;
  }
  scene.cache = zonal::HvlCache<1>(lights);
}
}  // namespace
