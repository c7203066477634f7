#include "primary_hits.hpp"

#include <algorithm>

namespace example {

std::size_t PrimaryHits::count() const {
  return static_cast<std::size_t>(
      std::count_if(hits_.begin(), hits_.end(), [](const auto& hit) { return hit.has_value(); }));
}

PrimaryHits trace_primary(const RayCaster& caster, const Camera& camera, int width, int height, Slice slice,
                          int antialias, const Stage& stage) {
  const CameraRays rays(camera, width, height);
  const auto columns = static_cast<std::size_t>(width);
  PrimaryHits hits(width, slice, antialias);
  for_each_pixel(hits.pixel_count(), stage, [&](std::size_t pixel) {
    const auto x = static_cast<float>(pixel % columns);
    const auto y = static_cast<float>(slice.first_row + static_cast<int>(pixel / columns));
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

}  // namespace example
