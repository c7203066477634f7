#pragma once

#include <cstdint>
#include <memory>

#include "lighting.hpp"
#include "lights.hpp"
#include "shared/random.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::grid_render {

/// Light by paths: lamps cast shadows, and surfaces light each other. All that it refers to must outlive it.
class Paths {
 public:
  Paths(const Scene& scene, const RayCaster& caster, const SphereLights& lights)
      : scene_(scene), caster_(caster), lights_(lights) {}

  const RayCaster& caster() const { return caster_; }
  const SphereLights& lights() const { return lights_; }

  /// Radiance that leaves `hit` towards the unit direction `outgoing`, as one path of most_surfaces finds it.
  glm::vec3 outgoing(Hit hit, glm::vec3 outgoing, Pcg32& random) const;

  /// The share of a lamp that a point in free space sees, by so many rays.
  float seen_share(const glm::vec3& position, const zonal::SphereLight<float>& lamp, int rays, Pcg32& random) const;

  static constexpr int most_surfaces = 5;

 private:
  glm::vec3 direct(const Hit& hit, const zonal::Brdf& brdf, const glm::vec3& outgoing, Pcg32& random) const;

  const Scene& scene_;
  const RayCaster& caster_;
  const SphereLights& lights_;
};

/// The lamps' light by `count` paths: of the exact field at each point seen, of a grid at each vertex, which is moved
/// out of walls first. Grids hold values alone, and know what their vertices see.
std::unique_ptr<Lighting> make_path_lighting(const Scene& scene, const RayCaster& caster, const SphereLights& lights,
                                             int bands, int count);

}  // namespace example::grid_render
