#pragma once

#include <glm/glm.hpp>
#include <zonal/material/brdf.hpp>

#include "ray_caster.hpp"

namespace example {

/// A step of a path: light that comes from `direction` and leaves a surface towards where the path came from.
struct Scattered {
  glm::vec3 direction;        // unit, world
  glm::vec3 reflected{0.0f};  // BRDF times cosine; black behind the triangle, whatever the normal says
  float density = 0.0f;       // per steradian; zero where the path ends
};

/// In a direction that the material chooses, by numbers in [0, 1).
Scattered scatter(const zonal::Brdf& brdf, const Hit& hit, const glm::vec3& outgoing, float u_lobe, const glm::vec2& u);

/// The same for a direction that something else chose.
Scattered scatter_towards(const zonal::Brdf& brdf, const Hit& hit, const glm::vec3& outgoing,
                          const glm::vec3& direction);

}  // namespace example
