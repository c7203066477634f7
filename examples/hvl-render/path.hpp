#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/random.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

struct PathSettings {
  int samples_per_pixel = 256;
  int bounces = 1;
  std::uint64_t seed = 1;
};

/// Monte Carlo estimates of indirect light. The first bounce is sampled twice: by the material (one density
/// for the mixture of its lobes) and by the spotlight, which chooses what it lights; the balance heuristic
/// joins them. Further bounces follow the material. At every surface but the first a shadow ray looks for the
/// spotlight.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const RayCaster& caster, const PathSettings& settings, int antialias);

  /// The mean over this sample's share of the paths. `sample` numbers it within the image and seeds its
  /// random numbers.
  glm::vec3 indirect_radiance(const Hit& hit, std::size_t sample) const;

  /// Paths per pixel: what was asked for, rounded up to as many at each position.
  int samples_per_pixel() const { return paths_per_position_ * positions_; }

 private:
  glm::vec3 path_by_material(const Hit& start, const glm::vec3& to_camera, Pcg32& random, float u_lobe,
                             const glm::vec2& u) const;
  glm::vec3 path_by_spotlight(const Hit& start, const glm::vec3& to_camera, const glm::vec2& u) const;
  float spotlight_density(const Hit& from, const Hit& lit) const;

  const Scene& scene_;
  const RayCaster& caster_;
  PathSettings settings_;
  int positions_;
  int paths_per_position_;
};

}  // namespace example::hvl_render
