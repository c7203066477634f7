#pragma once

#include <filesystem>
#include <memory>

#include <glm/glm.hpp>
#include <zonal/grid/interpolation_weights.hpp>
#include <zonal/transform/window.hpp>

#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"
#include "shared/split_material.hpp"

namespace example::field_render {

/// Of what is not matte: as many bands as the grid has too, and the window of its gloss.
struct GlossShading {
  int bands = 5;
  zonal::Window window = zonal::Window::none;
};

/// The light of a coefficient grid. Safe to use from many threads.
class GridLight {
 public:
  GridLight() = default;
  virtual ~GridLight() = default;
  GridLight(const GridLight&) = delete;
  GridLight& operator=(const GridLight&) = delete;

  virtual Bounds box() const = 0;
  virtual glm::ivec3 resolution() const = 0;
  virtual int bands() const = 0;

  /// Radiance that leaves `hit` towards the unit direction `outgoing`, not below 0: of matte surfaces by three bands in
  /// closed form, of others by as many as `shading` says of their material's table.
  virtual glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const SplitMaterial& material,
                              const GlossShading& shading) const = 0;
};

/// A grid of 3 to 6 bands, with gradients or without. Throws InputError.
std::unique_ptr<GridLight> load_grid_light(const std::filesystem::path& path, zonal::Interpolation interpolation);

}  // namespace example::field_render
