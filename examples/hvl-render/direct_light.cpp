#include "direct_light.hpp"

#include <cmath>

#include "shared/frame.hpp"

namespace example::hvl_render {

glm::vec3 unshadowed_radiance(const Scene& scene, const Hit& hit, const glm::vec3& outgoing) {
  const glm::vec3 offset = scene.light.position - hit.position;
  const float squared_distance = glm::dot(offset, offset);
  const glm::vec3 to_light = offset / std::sqrt(squared_distance);
  const float cosine = glm::dot(hit.normal, to_light);
  const glm::vec3 intensity = scene.light.intensity_towards(-to_light);
  if (cosine <= 0.0f || intensity == glm::vec3(0.0f)) return glm::vec3(0.0f);
  const Frame frame(hit.normal, hit.tangent);
  return zonal::evaluate(brdf_at(scene, hit), frame.to_local(to_light), frame.to_local(outgoing)) * intensity *
         (cosine / squared_distance);
}

glm::vec3 direct_radiance(const Scene& scene, const RayCaster& caster, const Hit& hit, const glm::vec3& outgoing) {
  const glm::vec3 radiance = unshadowed_radiance(scene, hit, outgoing);
  return radiance != glm::vec3(0.0f) && caster.visible(hit, scene.light.position) ? radiance : glm::vec3(0.0f);
}

}  // namespace example::hvl_render
