#include "virtual_lights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

#include <tbb/parallel_for.h>
#include <zonal/gather/radius.hpp>
#include <zonal/material/material_file.hpp>
#include <zonal/transform/window.hpp>

#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/output_file.hpp"

namespace example::hvl_render {
namespace {

/// The light of what a ray along the direction hits; its flux is zero where there is none.
zonal::VirtualLight light_at(const Scene& scene, const MaterialTables& tables, const glm::vec3& direction,
                             const std::optional<Hit>& hit, float texel_solid_angle) {
  zonal::VirtualLight light{};
  light.to_primary = -direction;
  if (!hit) return light;
  light.position = hit->position;
  light.normal = hit->normal;
  light.primary_distance = hit->distance;
  light.brdf = &scene.materials[hit->material].brdf;
  light.tangent = hit->tangent;
  if (!tables.emitting.empty()) {
    light.material = &tables.emitting[hit->material];
    light.anisotropic = tables.anisotropic[hit->material].get();
  }
  // Intensity times solid angle is all the light that lands there, whatever the surface's slope.
  light.flux = scene.light.intensity_towards(direction) * texel_solid_angle;
  return light;
}

/// What a virtual light of a material in parts stands on.
struct Surface {
  std::uint32_t material = 0;
  glm::vec3 colour{1.0f}, geometric_normal{0.0f};
};

/// Leaves the light what the rest of its material reflects, if there is any, and returns what the body does.
zonal::VirtualLight split_body(zonal::VirtualLight& light, const MaterialParts& parts, const Surface& surface) {
  if (parts.body.lobes.empty()) return {};
  zonal::VirtualLight body = light;
  body.flux *= surface.colour;
  body.brdf = &parts.body;
  body.material = parts.emitting ? &*parts.emitting : nullptr;
  body.anisotropic = nullptr;
  const bool has_rest = !parts.rest.lobes.empty();
  light.brdf = has_rest ? &parts.rest : nullptr;
  if (!has_rest) light.material = nullptr;
  return body;
}

/// The relief catches light by its own normal, but it is the surface's area that sends it: so does the body. What is
/// glossy sends it by the relief's normal, about which its lobes lie: an approximation.
void apply_relief(zonal::VirtualLight& light, zonal::VirtualLight& body, const Surface& surface) {
  const float caught = glm::dot(light.normal, light.to_primary);
  const float share = caught / std::max(glm::dot(surface.geometric_normal, light.to_primary), 1e-4f);
  light.flux *= share;
  body.flux *= share;
  body.normal = surface.geometric_normal;
}

void set_radii(std::vector<zonal::VirtualLight>& map, int side, const Spotlight& spotlight, const Options& options) {
  if (options.radius == RadiusRule::fixed) {
    zonal::set_fixed_radii(map.data(), side * side, options.fixed_radius);
    return;
  }
  zonal::set_field_of_view_radii(map.data(), side * side, 2.0f * spotlight.half_angle, options.radius_factor);
  if (options.radius == RadiusRule::neighbours) {  // but for lights that have none
    zonal::set_neighbour_radii(map.data(), side, side, options.radius_factor);
  }
}

}  // namespace

std::size_t bytes_of(const zonal::MaterialTable& table) {
  return (table.with_cosine_rows().size() + table.without_cosine_rows().size()) * sizeof(glm::vec3);
}
std::size_t ReceivingTable::bytes() const { return kept_ ? kept_->bytes() : bytes_of(*whole_); }

std::size_t MaterialTables::bytes() const {
  std::size_t sum = 0;
  for (const ReceivingTable& table : receiving) sum += table.bytes();
  for (const zonal::MaterialTable& table : emitting) sum += bytes_of(table);
  for (const auto& [material, of] : parts) {
    sum += (of.receiving ? of.receiving->bytes() : 0) + (of.emitting ? bytes_of(*of.emitting) : 0);
  }
  return sum;
}

int greatest_side(const Options& options) {
  const int most = static_cast<int>(std::sqrt(static_cast<double>(most_lights)));
  return std::min(most, most_texels_across / block_side(options));
}

VirtualLightMap shoot_virtual_lights(const Scene& scene, const RayCaster& caster, const MaterialTables& tables,
                                     const Options& options) {
  const int side = map_side(options);
  const float texel_solid_angle = scene.light.solid_angle() / (static_cast<float>(side) * static_cast<float>(side));
  const std::size_t size = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  VirtualLightMap map{side, std::vector<zonal::VirtualLight>(size), {}};
  std::vector<Surface> surfaces(tables.parts.empty() ? 0 : size);
  tbb::parallel_for(0, side * side, [&](int texel) {
    const glm::vec2 place((static_cast<float>(texel % side) + 0.5f) / static_cast<float>(side),
                          (static_cast<float>(texel / side) + 0.5f) / static_cast<float>(side));
    const auto i = static_cast<std::size_t>(texel);
    const glm::vec3 direction = cone_direction(scene.light, place);
    const std::optional<Hit> hit = caster.closest(scene.light.position, direction);
    map.lights[i] = light_at(scene, tables, direction, hit, texel_solid_angle);
    if (!surfaces.empty() && hit) surfaces[i] = {hit->material, hit->colour, hit->geometric_normal};
  });
  set_radii(map.lights, side, scene.light, options);
  map.bodies.resize(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const auto parts = tables.parts.find(surfaces[i].material);
    if (!is_lit(map.lights[i]) || parts == tables.parts.end()) continue;
    map.bodies[i] = split_body(map.lights[i], parts->second, surfaces[i]);
    if (scene.materials[surfaces[i].material].relief) apply_relief(map.lights[i], map.bodies[i], surfaces[i]);
  }
  return map;
}

std::vector<zonal::VirtualLight> lit(const VirtualLightMap& map) {
  std::vector<zonal::VirtualLight> lights;
  std::copy_if(map.lights.begin(), map.lights.end(), std::back_inserter(lights), is_lit);
  std::copy_if(map.bodies.begin(), map.bodies.end(), std::back_inserter(lights), is_lit);
  return lights;
}

namespace {

constexpr double model_tolerance = 1e-4;
constexpr double merl_tolerance = 1e-3;  // for the kinks between samples, a tenth of the time
constexpr double rgl_tolerance = 3e-3;   // of the last refinement: the error is a tenth of it

double tolerance_of(const Material& material) {
  if (material.file.empty()) return model_tolerance;
  return material.file.extension() == ".bsdf" ? rgl_tolerance : merl_tolerance;
}

/// Of a material from a file: what its projection is known by. Files of equal content are one.
std::optional<std::uint64_t> fingerprint(const Material& material) {
  if (material.file.empty()) return std::nullopt;
  try {
    return zonal::material_fingerprint(material.file, zonal::MaterialTable::max_bands, tolerance_of(material));
  } catch (const zonal::FileError& error) {
    throw InputError(error.what());
  }
}

/// A table that projects a row when it is asked for one; every 4 degrees of azimuth.
std::shared_ptr<const zonal::AnisotropicTable> anisotropic_table(const Material& material, int bands,
                                                                 const Options& options) {
  constexpr int azimuths = 90;
  auto table = std::make_shared<zonal::AnisotropicTable>(material.brdf, bands, tolerance_of(material), azimuths);
  table->set_windows(options.window, options.bands, options.emission_bands);
  return table;
}

/// From the cache, where there is one and the material comes from a file.
zonal::MaterialTable project(const Material& material, std::optional<std::uint64_t> fingerprint, int bands,
                             const Options& options) {
  const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };
  const double tolerance = tolerance_of(material);
  if (!fingerprint || options.material_cache.empty()) {
    return zonal::project_material(material.brdf, bands, tolerance, for_each);
  }
  std::ostringstream name;
  name << material.file.stem().string() << '-' << std::hex << std::setw(16) << std::setfill('0') << *fingerprint;
  const std::filesystem::path path = std::filesystem::path(options.material_cache) / (name.str() + ".table");
  try {
    return zonal::cached_material_table(path, *fingerprint, [&] {
      return zonal::project_material(material.brdf, zonal::MaterialTable::max_bands, tolerance, for_each);
    });
  } catch (const zonal::FileError& error) {
    throw InputError(error.what());
  }
}

/// The body's tables are there for HVL.
MaterialParts split(const Material& material, int bands, const Options& options) {
  MaterialParts parts{body_and_rest(material.brdf), {}, {}};
  if (options.method != Method::hvl) return parts;
  const zonal::MaterialTable table = project({material.name, parts.body}, std::nullopt, bands, options);
  parts.receiving = table.windowed(options.window, options.bands);
  parts.emitting = table.windowed(options.window, options.emission_bands);
  return parts;
}

}  // namespace

MaterialTables project_materials(const std::vector<Material>& materials, const Options& options) {
  const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };
  const int bands = std::max(options.bands, options.emission_bands);
  std::optional<OutputDirectory> cache;
  if (options.method == Method::hvl && !options.material_cache.empty()) cache.emplace(options.material_cache);
  MaterialTables tables;
  std::map<std::uint64_t, std::size_t> projected;  // files, and the first material of each
  for (const Material& material : materials) {
    throw_if_interrupted();
    const MaterialParts* parts = nullptr;
    if (material.colour || material.relief) {
      const auto number = static_cast<std::uint32_t>(&material - materials.data());
      parts = &tables.parts.emplace(number, split(material, bands, options)).first->second;
    }
    const std::optional<std::uint64_t> file = fingerprint(material);
    const auto known = file ? projected.find(*file) : projected.end();
    const bool isotropic = is_isotropic(material.brdf);
    if (options.method == Method::hvl_zonal) {
      if (!isotropic)
        throw InputError(material.file.string() + ": is anisotropic, which --method hvl-zonal does not take");
      tables.zonal.push_back(known != projected.end() ? zonal::ZonalTable(tables.zonal[known->second])
                                                      : zonal::project_zonal(material.brdf, options.bands,
                                                                             tolerance_of(material), for_each));
    } else if (options.method == Method::hvl) {
      if (known != projected.end()) {
        const std::size_t first = known->second;
        tables.receiving.push_back(ReceivingTable(tables.receiving[first]));
        tables.emitting.push_back(zonal::MaterialTable(tables.emitting[first]));
        tables.anisotropic.push_back(std::shared_ptr<const zonal::AnisotropicTable>(tables.anisotropic[first]));
        continue;
      }
      const bool has_body = parts && !parts->body.lobes.empty();
      const zonal::MaterialTable table =
          isotropic ? project(has_body ? Material{material.name, parts->rest} : material, file, bands, options)
                    : zonal::project_material(zonal::Brdf{}, bands);
      tables.receiving.push_back(table.windowed(options.window, options.bands));
      tables.emitting.push_back(table.windowed(options.window, options.emission_bands));
      tables.anisotropic.push_back(isotropic ? nullptr : anisotropic_table(material, bands, options));
      tables.error = std::max(tables.error, table.achieved_error());
      if (parts) tables.error = std::max(tables.error, parts->receiving->whole().achieved_error());
    }
    if (file) projected.emplace(*file, static_cast<std::size_t>(&material - materials.data()));
  }
  return tables;
}

}  // namespace example::hvl_render
