#pragma once

#include <glm/glm.hpp>

#include "scene.hpp"

namespace example {

/// A tangent for want of texture coordinates: horizontal, counter-clockwise seen from above (y is up); where the
/// surface is level, along x. Materials are thus brushed around the vertical axis. Not of unit length.
glm::vec3 horizontal_tangent(const glm::vec3& normal);

/// Sets the tangents of a mesh, if it has texture coordinates: at each vertex the mean, by angle, over the triangles
/// about it. Splits vertices where triangles mirror the texture and others do not. Where the coordinates of no triangle
/// about a vertex say a direction, as where they are all the same, its tangent is the horizontal one.
void set_tangents(Mesh& mesh);

}  // namespace example
