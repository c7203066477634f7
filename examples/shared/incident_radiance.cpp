#include "incident_radiance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scatter.hpp"

namespace example {

IncidentRadiance::Arrival IncidentRadiance::arrival(const Emitter& emitter, const glm::vec3& place,
                                                    const glm::vec2& square, int count) const {
  Arrival arrival;
  arrival.point = emitter.point(square);
  const glm::vec3 offset = arrival.point - place;
  const float squared_distance = std::max(glm::dot(offset, offset), 1e-12f);
  arrival.direction = offset / std::sqrt(squared_distance);
  const float cosine = -glm::dot(arrival.direction, emitter.normal());
  if (cosine <= 0.0f) return arrival;
  arrival.irradiance = emitter.radiance_towards(-arrival.direction) *
                       (cosine * emitter.area() / (squared_distance * static_cast<float>(count)));
  return arrival;
}

/// Light straight from the emitters, one sample of each: most beams miss, and cost no ray.
glm::vec3 IncidentRadiance::direct(const Hit& at, const glm::vec3& outgoing, Pcg32& random) const {
  glm::vec3 sum(0.0f);
  for (const Emitter& emitter : emitters_) {
    const Arrival light = arrival(emitter, at.position, random.uniform2(), 1);
    if (light.irradiance == glm::vec3(0.0f)) continue;
    const glm::vec3 reflected = scatter_towards(brdf_at(scene_, at), at, outgoing, light.direction).reflected;
    if (reflected == glm::vec3(0.0f) || !caster_.visible(at, light.point)) continue;
    sum += reflected * light.irradiance;
  }
  return sum;
}

glm::vec3 IncidentRadiance::leaving(Hit at, glm::vec3 outgoing, Pcg32& random) const {
  glm::vec3 sum = scene_.materials[at.material].emission, throughput(1.0f);
  for (int bounce = 0;; ++bounce) {
    sum += throughput * direct(at, outgoing, random);
    if (bounce == bounces_) return sum;
    const float u_lobe = random.uniform();
    const Scattered scattered = scatter(brdf_at(scene_, at), at, outgoing, u_lobe, random.uniform2());
    if (scattered.density <= 0.0f || scattered.reflected == glm::vec3(0.0f)) return sum;
    const std::optional<Hit> next = caster_.closest_from(at, scattered.direction);
    if (!next) return sum;
    throughput *= scattered.reflected / scattered.density;
    at = *next;
    outgoing = -scattered.direction;
  }
}

glm::vec3 IncidentRadiance::of_surfaces(const glm::vec3& origin, const glm::vec3& direction, Pcg32& random) const {
  const std::optional<Hit> hit = caster_.closest(origin, direction);
  return hit ? leaving(*hit, -direction, random) : glm::vec3(0.0f);
}

glm::vec3 IncidentRadiance::along_ray(const glm::vec3& origin, const glm::vec3& direction, Pcg32& random) const {
  const std::optional<Hit> hit = caster_.closest(origin, direction);
  const Emitter* nearest = nullptr;
  float least = hit ? hit->distance : std::numeric_limits<float>::infinity();
  for (const Emitter& emitter : emitters_) {
    if (emitter.shape != Emitter::Shape::rectangle) continue;
    const std::optional<float> distance = emitter.distance(origin, direction);
    if (!distance || *distance >= least) continue;
    nearest = &emitter;
    least = *distance;
  }
  if (nearest != nullptr) return nearest->radiance_towards(-direction);
  return hit ? leaving(*hit, -direction, random) : glm::vec3(0.0f);
}

}  // namespace example
