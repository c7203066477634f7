#pragma once

#include <cstdint>

#include "shared/incident_radiance.hpp"
#include "shared/ray_caster.hpp"

namespace example::field_render {

/// Radiance that leaves a hit on an inserted thing towards `outgoing`, by paths into a scene in which the thing is not:
/// of lamps by their area, of surfaces as the material chooses. `count` paths, random numbers of `seed`.
glm::vec3 true_radiance(const IncidentRadiance& light, const zonal::Brdf& brdf, const Hit& hit,
                        const glm::vec3& outgoing, int count, std::uint64_t seed);

}  // namespace example::field_render
