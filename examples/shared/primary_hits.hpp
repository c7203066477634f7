#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "image.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "ray_caster.hpp"
#include "scene.hpp"

namespace example {

/// Some rows of the image: large images are rendered slice by slice, so that their primary hits fit in
/// memory.
struct Slice {
  int first_row;
  int rows;
};

/// What the camera sees at the antialias x antialias positions of each pixel of a slice.
class PrimaryHits {
 public:
  PrimaryHits(int width, Slice slice, int antialias)
      : slice_(slice),
        width_(width),
        per_pixel_(static_cast<std::size_t>(antialias) * static_cast<std::size_t>(antialias)),
        hits_(pixel_count() * per_pixel_) {}

  Slice slice() const { return slice_; }
  std::size_t pixel_count() const { return static_cast<std::size_t>(slice_.rows) * static_cast<std::size_t>(width_); }
  /// Of a pixel, by column and row.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::size_t per_pixel() const { return per_pixel_; }

  std::span<std::optional<Hit>> of_pixel(std::size_t pixel) { return {&hits_[pixel * per_pixel_], per_pixel_}; }
  std::span<const std::optional<Hit>> of_pixel(std::size_t pixel) const {
    return {&hits_[pixel * per_pixel_], per_pixel_};
  }

  /// How many positions see a surface.
  std::size_t count() const;

 private:
  Slice slice_;
  int width_;
  std::size_t per_pixel_;
  std::vector<std::optional<Hit>> hits_;
};

/// body(slice) for the slices of an image, from the top.
template <class Body>
void for_each_slice(int width, int height, int antialias, const Body& body) {
  // Some 80 bytes per primary sample: a slice of a million is enough for many threads and little to hold.
  constexpr int samples_per_slice = 1 << 20;
  const int rows_per_slice = std::max(1, samples_per_slice / (width * antialias * antialias));
  for (int row = 0; row < height; row += rows_per_slice) body(Slice{row, std::min(rows_per_slice, height - row)});
}

/// What a stage reports while it runs; cost_per_pixel is in the units that Progress expects.
struct Stage {
  Progress& progress;
  const char* label;
  double cost_per_pixel;
};

/// body(pixel) for every pixel of a slice, on all threads; throws Interrupted soon after Ctrl-C.
template <class Body>
void for_each_pixel(std::size_t pixel_count, const Stage& stage, const Body& body) {
  constexpr std::size_t grain = 64;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixel_count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t pixel = range.begin(); pixel != range.end() && !stop_requested(); ++pixel)
                        body(pixel);
                      stage.progress.advance(stage.label, stage.cost_per_pixel * static_cast<double>(range.size()));
                    });
  throw_if_interrupted();
}

/// Adds to each pixel the mean of radiance(hit, number of the sample in the image) over its primary hits.
template <class Radiance>
void add_radiance(Image& image, const PrimaryHits& hits, const Stage& stage, const Radiance& radiance) {
  const std::size_t first_pixel = image.index(0, hits.slice().first_row);
  for_each_pixel(hits.pixel_count(), stage, [&](std::size_t pixel) {
    glm::vec3 sum(0.0f);
    std::size_t sample = (first_pixel + pixel) * hits.per_pixel();
    for (const std::optional<Hit>& hit : hits.of_pixel(pixel)) {
      if (hit) sum += radiance(*hit, sample);
      ++sample;
    }
    image.pixels[first_pixel + pixel] += sum / static_cast<float>(hits.per_pixel());
  });
}

PrimaryHits trace_primary(const RayCaster& caster, const Camera& camera, int width, int height, Slice slice,
                          int antialias, const Stage& stage);

inline glm::vec3 towards_camera(const Scene& scene, const Hit& hit) {
  return glm::normalize(scene.camera.position - hit.position);
}

}  // namespace example
