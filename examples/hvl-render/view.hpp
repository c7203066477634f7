#pragma once

#include "options.hpp"
#include "scene.hpp"

namespace hvl_render {

/// The scene that the options name, with the camera and the light they set. Throws InputError.
Scene load_scene(const Options& options);

}  // namespace hvl_render
