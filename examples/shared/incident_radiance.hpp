#pragma once

#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "emitter.hpp"
#include "random.hpp"
#include "ray_caster.hpp"
#include "scatter.hpp"
#include "scene.hpp"

namespace example {

/// Radiance that arrives in free space of a scene lit by emitters, by Monte Carlo paths: of emitters by their area,
/// with a shadow ray, at the place itself and at every surface of a path; between surfaces the material chooses.
/// Scene and caster must outlive it. Safe to use from many threads.
class IncidentRadiance {
 public:
  IncidentRadiance(const Scene& scene, const RayCaster& caster, std::vector<Emitter> emitters, int bounces)
      : scene_(scene), caster_(caster), emitters_(std::move(emitters)), bounces_(bounces) {}

  const std::vector<Emitter>& emitters() const { return emitters_; }

  /// From a unit direction, one estimate of what surfaces send, emitters themselves left out.
  glm::vec3 of_surfaces(const glm::vec3& origin, const glm::vec3& direction, Pcg32& random) const;

  /// The same, or the rectangle that is met before: rectangles are what rays see well. Discs, which rays would miss,
  /// are left out: their share is arrival()'s.
  glm::vec3 along_ray(const glm::vec3& origin, const glm::vec3& direction, Pcg32& random) const;

  /// A point of an emitter, as it is seen from a place.
  struct Arrival {
    glm::vec3 point, direction;  // unit, to the point
    glm::vec3 irradiance{0.0f};  // radiance times the solid angle of its share of the emitter, one of `count`
  };
  Arrival arrival(const Emitter& emitter, const glm::vec3& place, const glm::vec2& square, int count) const;

  bool visible(const glm::vec3& a, const glm::vec3& b) const { return caster_.visible(a, b); }

 private:
  glm::vec3 leaving(Hit at, glm::vec3 outgoing, Pcg32& random) const;
  glm::vec3 direct(const Hit& at, const glm::vec3& outgoing, Pcg32& random) const;

  const Scene& scene_;
  const RayCaster& caster_;
  std::vector<Emitter> emitters_;
  int bounces_;
};

}  // namespace example
