#pragma once

#include <cmath>
#include <optional>

#include <glm/glm.hpp>

namespace example::field_capture {

/// A mirror sphere that a far eye sees along `forward`: the ray that leaves it along a direction d starts where the
/// normal is, between d and the way to the eye. Of radius 0 it is one viewpoint. Offsets are from the sphere's centre.
struct MirrorBall {
  glm::dvec3 forward{1.0, 0.0, 0.0};  // unit
  double radius = 0.0;

  /// Where the ray along a unit direction starts. Right ahead, at the rim all around, there is no such place.
  glm::dvec3 start(const glm::dvec3& direction) const {
    if (radius == 0.0) return glm::dvec3(0.0);
    return radius * glm::normalize(direction - forward);
  }

  struct View {
    glm::dvec3 start, direction;
    double stretch;  // the solid angle of the rays that meet an area, over that of the area as seen from the start
  };

  /// How the mirror shows a point outside it; nothing where that is behind the ball, or within a degree or so of it.
  std::optional<View> view(const glm::dvec3& point) const {
    View seen{glm::dvec3(0.0), glm::normalize(point), 1.0};
    if (radius == 0.0) return seen;
    constexpr int most_steps = 60;
    double change = 1.0;
    // It comes closer by radius / (distance |direction - forward|) in each step.
    for (int step = 0; step < most_steps && change > 1e-13; ++step) {
      seen.start = start(seen.direction);
      const glm::dvec3 next = glm::normalize(point - seen.start);
      change = glm::distance(next, seen.direction);
      seen.direction = next;
    }
    if (!(change <= 1e-9)) return std::nullopt;
    // A beam of parallel rays leaves a convex mirror as if from two lines behind it: at R/2 cos i in the plane of
    // incidence, at R/2 / cos i across it.
    const double cosine = -glm::dot(seen.start, forward) / radius, distance = glm::distance(point, seen.start);
    const double in_plane = 0.5 * radius * cosine, across = 0.5 * radius / cosine;
    seen.stretch = distance * distance / ((distance + in_plane) * (distance + across));
    return seen;
  }
};

}  // namespace example::field_capture
