#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace example {

/// A flat lamp that shines to one side and stands in nobody's way: a rectangle, or a disc.
struct Emitter {
  /// What it sends where: the same everywhere; into a cone with an edge of a fiftieth of its angle; or four squares,
  /// two by two, each of a colour of its own. Beams are of directions alone, as if in focus at infinity: their edges
  /// are as soft as the lamp is wide.
  enum class Beam { even, cone, squares };
  enum class Shape { rectangle, disc };

  Shape shape = Shape::rectangle;
  glm::vec3 centre{0.0f};              // metres
  glm::vec3 half_u{0.5f, 0.0f, 0.0f};  // from the centre to the middle of a side, or to the rim
  glm::vec3 half_v{0.0f, 0.0f, 0.5f};  // the same, at a right angle; half_u x half_v points where it shines
  glm::vec3 radiance{1.0f};            // W/(m^2 sr)
  Beam beam = Beam::even;
  float half_angle = 0.0f;  // radians: of the cone, or from the axis to the pattern's nearest edge

  /// A disc at a place that shines at another.
  static Emitter projector(const glm::vec3& from, const glm::vec3& at, float radius, Beam beam, float half_angle,
                           const glm::vec3& radiance);

  glm::vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
  float area() const;

  /// Equal areas of the unit square become equal areas of the lamp.
  glm::vec3 point(const glm::vec2& square) const;

  /// Radiance that it sends along a unit direction, away from it.
  glm::vec3 radiance_towards(const glm::vec3& direction) const;

  /// How far along a ray its shining side is met.
  std::optional<float> distance(const glm::vec3& origin, const glm::vec3& direction) const;
};

}  // namespace example
