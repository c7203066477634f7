#include "path.hpp"

#include <cmath>

#include "direct_light.hpp"
#include "shared/interrupt.hpp"
#include "shared/primary_hits.hpp"
#include "shared/scatter.hpp"
#include "shared/spread_points.hpp"

namespace example::hvl_render {

PathTracer::PathTracer(const Scene& scene, const RayCaster& caster, const PathSettings& settings, int antialias)
    : scene_(scene),
      caster_(caster),
      settings_(settings),
      positions_(antialias * antialias),
      paths_per_position_((settings.samples_per_pixel + positions_ - 1) / positions_) {}

/// With what density, per steradian about `from`, the spotlight's equal solid angles choose the surface at
/// `lit`.
float PathTracer::spotlight_density(const Hit& from, const Hit& lit) const {
  const glm::vec3 to_light = scene_.light.position - lit.position;
  const glm::vec3 to_start = from.position - lit.position;
  const float squared_light_distance = glm::dot(to_light, to_light);
  const float squared_distance = glm::dot(to_start, to_start);
  const float light_cosine = glm::dot(to_light, lit.geometric_normal) / std::sqrt(squared_light_distance);
  const float cosine = glm::dot(to_start, lit.geometric_normal) / std::sqrt(squared_distance);
  if (!(light_cosine > 0.0f && cosine > 0.0f)) return 0.0f;
  const float per_area = light_cosine / (scene_.light.solid_angle() * squared_light_distance);
  return per_area * squared_distance / cosine;
}

glm::vec3 PathTracer::path_by_material(const Hit& start, const glm::vec3& to_camera, Pcg32& random, float u_lobe,
                                       const glm::vec2& u) const {
  Hit at = start;
  Scattered scattered = scatter(brdf_at(scene_, at), at, to_camera, u_lobe, u);
  glm::vec3 throughput(1.0f);
  glm::vec3 sum(0.0f);
  for (int bounce = 0;; ++bounce) {
    if (scattered.density <= 0.0f || scattered.reflected == glm::vec3(0.0f)) return sum;
    const std::optional<Hit> next = caster_.closest_from(at, scattered.direction);
    if (!next) return sum;
    const glm::vec3 outgoing = -scattered.direction;
    const float other_density = bounce == 0 ? spotlight_density(start, *next) : 0.0f;
    const glm::vec3 radiance = direct_radiance(scene_, caster_, *next, outgoing);
    sum += throughput * scattered.reflected * radiance / (scattered.density + other_density);
    if (bounce + 1 == settings_.bounces) return sum;
    throughput *= scattered.reflected / scattered.density;
    at = *next;
    const float next_u_lobe = random.uniform();
    scattered = scatter(brdf_at(scene_, at), at, outgoing, next_u_lobe, random.uniform2());
  }
}

glm::vec3 PathTracer::path_by_spotlight(const Hit& start, const glm::vec3& to_camera, const glm::vec2& u) const {
  const glm::vec3 none(0.0f);
  std::optional<Hit> lit = caster_.closest(scene_.light.position, cone_direction(scene_.light, u));
  if (!lit) return none;
  const float density = spotlight_density(start, *lit);
  if (density <= 0.0f) return none;
  const glm::vec3 direction = glm::normalize(lit->position - start.position);
  const Scattered scattered = scatter_towards(brdf_at(scene_, start), start, to_camera, direction);
  if (scattered.reflected == none) return none;
  lit->normal = face_viewer(lit->normal, -direction);  // now seen from the start
  const glm::vec3 radiance = unshadowed_radiance(scene_, *lit, -direction);
  if (radiance == none || !caster_.visible(start, *lit)) return none;
  return scattered.reflected * radiance / (scattered.density + density);
}

glm::vec3 PathTracer::indirect_radiance(const Hit& hit, std::size_t sample) const {
  Pcg32 random(hash64(settings_.seed) ^ static_cast<std::uint64_t>(sample));
  const SpreadPoints material_points(random);
  const SpreadPoints spotlight_points(random);
  const glm::vec3 to_camera = towards_camera(scene_, hit);
  glm::vec3 sum(0.0f);
  const auto count = static_cast<std::uint32_t>(paths_per_position_);
  for (std::uint32_t path = 0; path < count && !stop_requested(); ++path) {
    const glm::vec4 u = material_points.point(path);
    sum += path_by_material(hit, to_camera, random, u.z, glm::vec2(u));
    sum += path_by_spotlight(hit, to_camera, glm::vec2(spotlight_points.point(path)));
  }
  return sum / static_cast<float>(paths_per_position_);
}

}  // namespace example::hvl_render
