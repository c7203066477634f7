#include "reference.hpp"

#include "shared/interrupt.hpp"
#include "shared/scatter.hpp"
#include "shared/spread_points.hpp"

namespace example::field_render {

glm::vec3 true_radiance(const IncidentRadiance& light, const zonal::Brdf& brdf, const Hit& hit,
                        const glm::vec3& outgoing, int count, std::uint64_t seed) {
  Pcg32 random(seed);
  const SpreadPoints on_lamps(random), by_material(random);
  glm::vec3 sum(0.0f);
  for (int path = 0; path < count && !stop_requested(); ++path) {
    const auto index = static_cast<std::uint32_t>(path);
    for (const Emitter& emitter : light.emitters()) {
      const auto lamp = light.arrival(emitter, hit.position, glm::vec2(on_lamps.point(index)), 1);
      if (lamp.irradiance == glm::vec3(0.0f)) continue;
      const glm::vec3 reflected = scatter_towards(brdf, hit, outgoing, lamp.direction).reflected;
      if (reflected == glm::vec3(0.0f) || !light.visible(hit.position, lamp.point)) continue;
      sum += reflected * lamp.irradiance;
    }
    const glm::vec4 u = by_material.point(index);
    const Scattered scattered = scatter(brdf, hit, outgoing, u.z, glm::vec2(u));
    if (scattered.density <= 0.0f) continue;
    sum += scattered.reflected / scattered.density * light.of_surfaces(hit.position, scattered.direction, random);
  }
  return sum / static_cast<float>(count);
}

}  // namespace example::field_render
