#pragma once

#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

/// Radiance that leaves `hit` towards the unit direction `outgoing`, by light straight from the spotlight: as
/// if nothing stood between, or with the shadow ray.
glm::vec3 unshadowed_radiance(const Scene& scene, const Hit& hit, const glm::vec3& outgoing);
glm::vec3 direct_radiance(const Scene& scene, const RayCaster& caster, const Hit& hit, const glm::vec3& outgoing);

}  // namespace example::hvl_render
