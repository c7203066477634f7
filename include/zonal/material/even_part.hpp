// Measured isotropic materials for the projection, which asks for functions even in phi.
#pragma once

#include <glm/vec3.hpp>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The part of an isotropic BRDF that is its own mirror image in the plane y = 0: (f + its mirror image) / 2, in 1/sr.
/// Measurements are not quite symmetric, and project_brdf looks at one half of the circle; of the even part, the
/// coefficients of m >= 0 are those of f itself. Refers to brdf, a callable (glm::dvec3 wi, glm::dvec3 wo) ->
/// glm::dvec3.
template <class F>
auto even_part(const F& brdf) {
  return [&brdf](const glm::dvec3& wi, const glm::dvec3& wo) {
    return 0.5 * (brdf(wi, wo) + brdf(glm::dvec3(wi.x, -wi.y, wi.z), glm::dvec3(wo.x, -wo.y, wo.z)));
  };
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
