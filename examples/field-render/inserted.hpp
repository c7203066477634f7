#pragma once

#include "options.hpp"
#include "shared/scene.hpp"

namespace example::field_render {

/// What stands in the box, and a camera before it: a table of four fifths of the box, a quarter of it above its floor,
/// alone, with figures on it, or with an OBJ file's contents. Throws InputError.
Scene make_inserted(const Options& options, const Bounds& box);

}  // namespace example::field_render
