#pragma once

#include "common_options.hpp"
#include "scene.hpp"

namespace example {

/// The scene that the options name, with its own camera. Throws InputError.
Scene open_scene(const CommonOptions& options);

/// Throws InputError where nothing would be in view.
void apply(const CameraOverrides& overrides, Camera& camera);

}  // namespace example
