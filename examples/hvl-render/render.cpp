#include "render.hpp"

#include <algorithm>
#include <cmath>

#include "frame.hpp"

namespace hvl_render {

std::size_t PrimaryHits::count() const {
  return static_cast<std::size_t>(
      std::count_if(hits_.begin(), hits_.end(), [](const auto& hit) { return hit.has_value(); }));
}

PrimaryHits trace_primary(const RayCaster& caster, const Camera& camera, const Image& image, Slice slice, int antialias,
                          const Stage& stage) {
  const CameraRays rays(camera, image.width, image.height);
  const auto width = static_cast<std::size_t>(image.width);
  PrimaryHits hits(image, slice, antialias);
  for_each_pixel(hits.pixel_count(), stage, [&](std::size_t pixel) {
    const auto x = static_cast<float>(pixel % width);
    const auto y = static_cast<float>(slice.first_row + static_cast<int>(pixel / width));
    int sample = 0;
    for (std::optional<Hit>& hit : hits.of_pixel(pixel)) {
      const float dx = (static_cast<float>(sample % antialias) + 0.5f) / static_cast<float>(antialias);
      const float dy = (static_cast<float>(sample / antialias) + 0.5f) / static_cast<float>(antialias);
      hit = caster.closest(camera.position, rays.direction(x + dx, y + dy));
      ++sample;
    }
  });
  return hits;
}

glm::vec3 unshadowed_radiance(const Scene& scene, const Hit& hit, const glm::vec3& outgoing) {
  const glm::vec3 offset = scene.light.position - hit.position;
  const float squared_distance = glm::dot(offset, offset);
  const glm::vec3 to_light = offset / std::sqrt(squared_distance);
  const float cosine = glm::dot(hit.normal, to_light);
  const glm::vec3 intensity = scene.light.intensity_towards(-to_light);
  if (cosine <= 0.0f || intensity == glm::vec3(0.0f)) return glm::vec3(0.0f);
  const Frame frame(hit.normal);
  const zonal::Brdf& brdf = scene.materials[hit.material].brdf;
  return zonal::evaluate(brdf, frame.to_local(to_light), frame.to_local(outgoing)) * intensity *
         (cosine / squared_distance);
}

glm::vec3 direct_radiance(const Scene& scene, const RayCaster& caster, const Hit& hit, const glm::vec3& outgoing) {
  const glm::vec3 radiance = unshadowed_radiance(scene, hit, outgoing);
  return radiance != glm::vec3(0.0f) && caster.visible(hit, scene.light.position) ? radiance : glm::vec3(0.0f);
}

}  // namespace hvl_render
