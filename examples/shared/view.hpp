#pragma once

#include "common_options.hpp"
#include "scene.hpp"

namespace example {

/// The scene that the options name, with its own camera. Throws InputError.
Scene open_scene(const CommonOptions& options);

/// So near to each other that a float cannot tell the direction.
bool is_same_point(const glm::vec3& a, const glm::vec3& b);

/// Throws InputError where nothing would be in view.
void apply(const CameraOverrides& overrides, Camera& camera);

}  // namespace example
