#include "scatter.hpp"

#include <zonal/material/sampling.hpp>

#include "frame.hpp"

namespace example {

Scattered scatter(const zonal::Brdf& brdf, const Hit& hit, const glm::vec3& outgoing, float u_lobe,
                  const glm::vec2& u) {
  const Frame frame(hit.normal, hit.tangent);
  const glm::vec3 local_outgoing = frame.to_local(outgoing);
  const zonal::BrdfSample sample = zonal::sample(brdf, local_outgoing, u_lobe, u);
  if (sample.pdf <= 0.0f) return {outgoing};
  const glm::vec3 direction = frame.to_world(sample.direction);
  if (glm::dot(direction, hit.geometric_normal) <= 0.0f) return {direction};
  const glm::vec3 reflected = zonal::evaluate(brdf, sample.direction, local_outgoing) * sample.direction.z;
  return {direction, reflected, sample.pdf};
}

Scattered scatter_towards(const zonal::Brdf& brdf, const Hit& hit, const glm::vec3& outgoing,
                          const glm::vec3& direction) {
  const Frame frame(hit.normal, hit.tangent);
  const glm::vec3 local_outgoing = frame.to_local(outgoing);
  const glm::vec3 local_direction = frame.to_local(direction);
  if (local_direction.z <= 0.0f || glm::dot(direction, hit.geometric_normal) <= 0.0f) return {direction};
  const glm::vec3 reflected = zonal::evaluate(brdf, local_direction, local_outgoing) * local_direction.z;
  return {direction, reflected, zonal::pdf(brdf, local_direction, local_outgoing)};
}

}  // namespace example
