#pragma once

#include "scene.hpp"

namespace example {

/// Camera, light and panel for a scene that has none, and the stage where it is to have one. A room, closed but for a
/// side at most, and its faces turned inwards, is seen from inside. Where materials shine, the light stands in their
/// place.
void place_camera_and_light(Scene& scene, const ObjView& view);

}  // namespace example
