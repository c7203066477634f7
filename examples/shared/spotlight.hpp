#pragma once

#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "frame.hpp"

namespace example {

/// A point source that shines into a cone with a smooth edge.
struct Spotlight {
  glm::vec3 position{0.0f};
  glm::vec3 axis{0.0f, -1.0f, 0.0f};  // unit
  glm::vec3 intensity{1.0f};          // W/sr on the axis
  float half_angle = 0.8f;            // radians, where the light ends
  float edge = 0.25f;                 // share of the half angle over which it fades

  float cos_half_angle() const { return std::cos(half_angle); }

  /// Radiant intensity, W/sr, towards a unit direction.
  glm::vec3 intensity_towards(const glm::vec3& direction) const {
    const float cos_inner = std::cos(half_angle * (1.0f - edge));
    return intensity * glm::smoothstep(cos_half_angle(), cos_inner, glm::dot(axis, direction));
  }

  /// Steradians of the cone.
  float solid_angle() const { return glm::two_pi<float>() * (1.0f - cos_half_angle()); }

  /// Steradians that, filled with the axis' intensity, hold the whole power: half of the fading edge counts.
  float effective_solid_angle() const {
    const float cos_inner = std::cos(half_angle * (1.0f - edge));
    return glm::two_pi<float>() * (1.0f - 0.5f * (cos_inner + cos_half_angle()));
  }
};

/// Shirley and Chiu's concentric map of the unit square to the unit disc: equal areas stay equal, neighbours
/// stay neighbours.
inline glm::vec2 square_to_disc(const glm::vec2& square) {
  const glm::vec2 p = 2.0f * square - 1.0f;
  if (p.x == 0.0f && p.y == 0.0f) return glm::vec2(0.0f);
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float quarter = glm::quarter_pi<float>();
  const float angle = wide ? quarter * (p.y / p.x) : glm::half_pi<float>() - quarter * (p.x / p.y);
  return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

/// Direction in the cone; equal areas of the unit square become equal solid angles.
inline glm::vec3 cone_direction(const Spotlight& light, const glm::vec2& square) {
  const glm::vec2 disc = square_to_disc(square);
  const float one_minus_cos = glm::dot(disc, disc) * (1.0f - light.cos_half_angle());
  // sin / r of the disc, free of the division by r: sin^2 = (1 - cos) (2 - (1 - cos)).
  const float scale = std::sqrt((1.0f - light.cos_half_angle()) * (2.0f - one_minus_cos));
  return Frame(light.axis).to_world(glm::vec3(disc * scale, 1.0f - one_minus_cos));
}

}  // namespace example
