#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace example {

/// Right-handed orthonormal frame about a unit normal, its z axis (Duff et al. 2017, "Building an Orthonormal
/// Basis, Revisited").
class Frame {
 public:
  explicit Frame(const glm::vec3& normal) : normal_(normal) {
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    tangent_ = glm::vec3(1.0f + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    bitangent_ = glm::vec3(b, sign + normal.y * normal.y * a, -normal.y);
  }

  /// With its x axis along the part of `tangent` that is normal to the normal; as above where there is none.
  Frame(const glm::vec3& normal, const glm::vec3& tangent) : Frame(normal) {
    const glm::vec3 flat = tangent - glm::dot(tangent, normal) * normal;
    const float length2 = glm::dot(flat, flat);
    if (!(length2 > 1e-12f)) return;
    tangent_ = flat / std::sqrt(length2);
    bitangent_ = glm::cross(normal, tangent_);
  }

  glm::vec3 to_local(const glm::vec3& world) const {
    return {glm::dot(world, tangent_), glm::dot(world, bitangent_), glm::dot(world, normal_)};
  }

  glm::vec3 to_world(const glm::vec3& local) const {
    return local.x * tangent_ + local.y * bitangent_ + local.z * normal_;
  }

 private:
  glm::vec3 tangent_{};
  glm::vec3 bitangent_{};
  glm::vec3 normal_;
};

}  // namespace example
