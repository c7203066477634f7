#pragma once

#include <glm/glm.hpp>

namespace example {

/// A rectangle that many small lights can fill.
struct LightPanel {
  glm::vec3 centre{0.0f};
  glm::vec3 half_u{1.0f, 0.0f, 0.0f};  // from the centre to the middle of a side, metres
  glm::vec3 half_v{0.0f, 0.0f, 1.0f};  // the same, at a right angle
  float distance = 1.0f;               // metres, to what it is there to light

  float area() const { return 4.0f * glm::length(half_u) * glm::length(half_v); }
};

}  // namespace example
