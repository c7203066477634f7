// How large a virtual light's sphere is: large enough that neighbours overlap, small enough not to blur the scene.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "virtual_light.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// r1 [1, Eq. 23]: the mean distance to the 8 neighbours in the map, weighted towards those at a similar distance from
/// the primary light. `map` holds width * height lights, row by row; neighbours without flux do not count, and a
/// light without any neighbour keeps the radius it has: set r2 before, or it is a point light. `epsilon` is a length
/// that guards the weight.
inline void set_neighbour_radii(VirtualLight* map, int width, int height, float factor, float epsilon = 1e-3F) {
  const auto is_dark = [](const VirtualLight& light) { return light.flux == glm::vec3(0); };
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      VirtualLight& light = map[row * width + column];
      float distance_sum = 0, weight_sum = 0;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
          const bool is_inside = 0 <= r && r < height && 0 <= c && c < width;
          if (!is_inside || (r == row && c == column)) continue;
          const VirtualLight& neighbour = map[r * width + c];
          if (is_dark(neighbour)) continue;
          const float weight = 1 / (std::abs(light.primary_distance - neighbour.primary_distance) + epsilon);
          distance_sum += weight * glm::distance(light.position, neighbour.position);
          weight_sum += weight;
        }
      }
      if (weight_sum > 0) light.radius = factor * distance_sum / weight_sum;
    }
  }
}

/// r2 [1, Eq. 24-26]: the distance between diagonal neighbours of a square map of `count` texels over
/// `field_of_view` radians, all as far from the primary light as this one. tan is its Taylor series, as printed:
/// within 0.01 for field_of_view / sqrt(count) < 0.41.
inline void set_field_of_view_radii(VirtualLight* lights, int count, float field_of_view, float factor) {
  const float gamma = std::sqrt(2.0F) * field_of_view / std::sqrt(static_cast<float>(count));
  const float tangent = gamma + gamma * gamma * gamma / 3;
  for (int i = 0; i < count; ++i) lights[i].radius = factor * lights[i].primary_distance * tangent;
}

/// The same radius, a length, for all.
inline void set_fixed_radii(VirtualLight* lights, int count, float radius) {
  for (int i = 0; i < count; ++i) lights[i].radius = radius;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
