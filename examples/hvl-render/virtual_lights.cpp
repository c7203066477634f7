#include "virtual_lights.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>
#include <zonal/gather/radius.hpp>
#include <zonal/transform/window.hpp>

#include "shared/interrupt.hpp"

namespace example::hvl_render {
namespace {

/// The light of one texel of the spotlight's map; its flux is zero where there is none.
zonal::VirtualLight shoot(const Scene& scene, const RayCaster& caster, const std::vector<zonal::MaterialTable>& tables,
                          const glm::vec2& texel, float texel_solid_angle) {
  const glm::vec3 direction = cone_direction(scene.light, texel);
  zonal::VirtualLight light{};
  light.to_primary = -direction;
  const std::optional<Hit> hit = caster.closest(scene.light.position, direction);
  if (!hit) return light;
  light.position = hit->position;
  light.normal = hit->normal;
  light.primary_distance = hit->distance;
  light.material = &tables[hit->material];
  // Intensity times solid angle is all the light that lands there, whatever the surface's slope.
  light.flux = scene.light.intensity_towards(direction) * texel_solid_angle;
  return light;
}

void set_radii(std::vector<zonal::VirtualLight>& map, int side, const Spotlight& spotlight, const Options& options) {
  switch (options.radius) {
    case RadiusRule::neighbours: zonal::set_neighbour_radii(map.data(), side, side, options.radius_factor); break;
    case RadiusRule::field_of_view:
      zonal::set_field_of_view_radii(map.data(), side * side, 2.0f * spotlight.half_angle, options.radius_factor);
      break;
    case RadiusRule::fixed: zonal::set_fixed_radii(map.data(), side * side, options.fixed_radius); break;
  }
}

}  // namespace

int map_side(int lights) { return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(lights)))); }

std::vector<zonal::VirtualLight> shoot_virtual_lights(const Scene& scene, const RayCaster& caster,
                                                      const std::vector<zonal::MaterialTable>& tables,
                                                      const Options& options) {
  const int side = map_side(options.lights);
  const float texel_solid_angle = scene.light.solid_angle() / static_cast<float>(side * side);
  std::vector<zonal::VirtualLight> map(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  tbb::parallel_for(0, side * side, [&](int i) {
    const glm::vec2 texel((static_cast<float>(i % side) + 0.5f) / static_cast<float>(side),
                          (static_cast<float>(i / side) + 0.5f) / static_cast<float>(side));
    map[static_cast<std::size_t>(i)] = shoot(scene, caster, tables, texel, texel_solid_angle);
  });
  // Radii look at neighbours in the map, so the dark ones go afterwards.
  set_radii(map, side, scene.light, options);
  std::erase_if(map, [](const zonal::VirtualLight& light) { return light.flux == glm::vec3(0.0f); });
  return map;
}

MaterialTables project_materials(const std::vector<Material>& materials, const Options& options) {
  const int bands = std::max(options.bands, options.emission_bands);
  const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };
  MaterialTables tables;
  for (const Material& material : materials) {
    throw_if_interrupted();
    const zonal::MaterialTable table = zonal::project_material(material.brdf, bands, 1e-4, for_each);
    tables.receiving.push_back(table.windowed(options.window, options.bands));
    tables.emitting.push_back(table.windowed(options.window, options.emission_bands));
    tables.error = std::max(tables.error, table.achieved_error());
  }
  return tables;
}

}  // namespace example::hvl_render
