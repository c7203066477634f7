#include "emitter.hpp"

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "frame.hpp"
#include "spotlight.hpp"

namespace example {
namespace {

/// Four squares in the square |x|, |y| <= 1, a tenth of its half side apart and off its edges.
glm::vec3 four_squares(const glm::vec2& place) {
  const glm::vec2 inner = glm::abs(place);
  if (std::min(inner.x, inner.y) < 0.1f || std::max(inner.x, inner.y) > 0.9f) return glm::vec3(0.0f);
  if (place.y > 0.0f) return place.x > 0.0f ? glm::vec3(1.0f, 0.05f, 0.02f) : glm::vec3(0.05f, 0.9f, 0.1f);
  return place.x > 0.0f ? glm::vec3(0.9f, 0.7f, 0.02f) : glm::vec3(0.05f, 0.15f, 1.0f);
}

}  // namespace

Emitter Emitter::projector(const glm::vec3& from, const glm::vec3& at, float radius, Beam beam, float half_angle,
                           const glm::vec3& radiance) {
  const glm::vec3 axis = glm::normalize(at - from);
  const Frame frame(axis, glm::cross(axis, glm::vec3(0.0f, 1.0f, 0.0f)));
  return {Shape::disc,
          from,
          radius * frame.to_world({1.0f, 0.0f, 0.0f}),
          radius * frame.to_world({0.0f, 1.0f, 0.0f}),
          radiance,
          beam,
          half_angle};
}

float Emitter::area() const {
  const float share = shape == Shape::disc ? glm::pi<float>() : 4.0f;
  return share * glm::length(half_u) * glm::length(half_v);
}

glm::vec3 Emitter::point(const glm::vec2& square) const {
  const glm::vec2 place = shape == Shape::disc ? square_to_disc(square) : 2.0f * square - 1.0f;
  return centre + place.x * half_u + place.y * half_v;
}

glm::vec3 Emitter::radiance_towards(const glm::vec3& direction) const {
  const float cosine = glm::dot(direction, normal());
  if (cosine <= 0.0f) return glm::vec3(0.0f);
  if (beam == Beam::even) return radiance;
  if (beam == Beam::cone) {
    const float angle = std::acos(std::min(cosine, 1.0f));
    return radiance * (1.0f - glm::smoothstep(0.98f * half_angle, half_angle, angle));
  }
  const float scale = 1.0f / (cosine * std::tan(half_angle));
  return radiance * four_squares(scale * glm::vec2(glm::dot(direction, glm::normalize(half_u)),
                                                   glm::dot(direction, glm::normalize(half_v))));
}

std::optional<float> Emitter::distance(const glm::vec3& origin, const glm::vec3& direction) const {
  const glm::vec3 n = normal();
  const float approach = -glm::dot(direction, n);
  if (approach <= 0.0f) return std::nullopt;
  const float along = glm::dot(origin - centre, n) / approach;
  if (along <= 0.0f) return std::nullopt;
  const glm::vec3 place = origin + along * direction - centre;
  const glm::vec2 p(glm::dot(place, half_u) / glm::dot(half_u, half_u),
                    glm::dot(place, half_v) / glm::dot(half_v, half_v));
  const bool met = shape == Shape::disc ? glm::dot(p, p) <= 1.0f : std::max(std::abs(p.x), std::abs(p.y)) <= 1.0f;
  return met ? std::optional(along) : std::nullopt;
}

}  // namespace example
