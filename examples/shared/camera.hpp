#pragma once

#include <cmath>

#include <glm/glm.hpp>

namespace example {

/// A pinhole camera; y is up.
struct Camera {
  glm::vec3 position{0.0f};
  glm::vec3 target{0.0f, 0.0f, -1.0f};
  float vertical_field_of_view = 0.8f;  // radians
};

/// Turns positions on the film into view directions.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height) : width_(width), height_(height) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const bool vertical = std::abs(forward.y) > 0.999f;
    const glm::vec3 up = vertical ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const float half_height = std::tan(0.5f * camera.vertical_field_of_view);
    const float half_width = half_height * static_cast<float>(width) / static_cast<float>(height);
    forward_ = forward;
    right_ = glm::normalize(glm::cross(forward, up)) * half_width;
    up_ = glm::normalize(glm::cross(right_, forward)) * half_height;
  }

  /// Unit direction through the film at (x, y) in pixels, the origin in the upper left corner.
  glm::vec3 direction(float x, float y) const {
    const float u = 2.0f * x / static_cast<float>(width_) - 1.0f;
    const float v = 1.0f - 2.0f * y / static_cast<float>(height_);
    return glm::normalize(forward_ + u * right_ + v * up_);
  }

 private:
  int width_;
  int height_;
  glm::vec3 forward_{};
  glm::vec3 right_{};
  glm::vec3 up_{};
};

}  // namespace example
