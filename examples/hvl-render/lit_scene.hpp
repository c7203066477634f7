#pragma once

#include "options.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

/// The scene that the options name, with the camera and the light they set. Throws InputError.
Scene load_scene(const Options& options);

}  // namespace example::hvl_render
