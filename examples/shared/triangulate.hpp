#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace example {

/// Along the polygon's normal, twice as long as it is large: the sum of the cross products of its edges (Newell).
glm::dvec3 newell_area(std::span<const glm::dvec3> corners);

/// Appends triangles that fill the polygon, as numbers of its corners, in its own turn: n - 2 of them, fewer where
/// corners lie on a line. The polygon may be concave, and may touch itself, as one does that goes to a hole and back;
/// flat it need not quite be. False where its outline crosses itself: then the triangles are some that use its corners.
/// Quadrilaterals are cut along the shorter diagonal that lies inside. Time: n log n where convex, at most n^2 as a
/// rule (spirals of 10^4 corners: 4 s).
bool triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace example
