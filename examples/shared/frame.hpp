#pragma once

#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <zonal/scalar/vector3.hpp>

namespace example {

/// Right-handed orthonormal frame about a unit normal, its z axis.
class Frame {
 public:
  explicit Frame(const glm::vec3& normal) : normal_(normal) {
    const float z[3] = {normal.x, normal.y, normal.z};
    float x[3], y[3];
    zonal::complete_frame(z, x, y);
    tangent_ = glm::make_vec3(x);
    bitangent_ = glm::make_vec3(y);
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
