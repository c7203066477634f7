#include "scene.hpp"

namespace example {

Bounds bounds_of(const Mesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds bounds{mesh.positions.front(), mesh.positions.front()};
  for (const glm::vec3& position : mesh.positions) {
    bounds.lower = glm::min(bounds.lower, position);
    bounds.upper = glm::max(bounds.upper, position);
  }
  return bounds;
}

}  // namespace example
