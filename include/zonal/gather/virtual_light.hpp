// Virtual lights: the points that a primary light illuminates, as lights of their own.
#pragma once

#include <glm/vec3.hpp>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

class MaterialTable;
class AnisotropicTable;
struct Brdf;

/// The least radius that a virtual light has for its gathers, a length: one that is smaller, or 0, is taken for a point
/// light all the same, and its 1 / r^2 stays within what floats hold.
inline constexpr float least_light_radius = 1e-9F;

/// One texel of a reflective shadow map: where light of a primary light arrives, and on what.
struct VirtualLight {
  glm::vec3 position{0};                          // up to 1e18 from what it lights
  glm::vec3 normal{0, 0, 1};                      // unit
  glm::vec3 to_primary{0, 0, 1};                  // unit, from the surface to the primary light
  glm::vec3 flux{0};                              // W, RGB, that arrives: intensity times the texel's solid angle
  float primary_distance = 0;                     // to the primary light
  float radius = 0;                               // of the sphere that stands for the texel's surface; see radius.hpp
  const MaterialTable* material = nullptr;        // for HVL: what it reflects, projected
  const Brdf* brdf = nullptr;                     // for all others: what it reflects, itself
  glm::vec3 tangent{0};                           // of an anisotropic material, as a receiver's
  const AnisotropicTable* anisotropic = nullptr;  // for HVL of such a material, instead of `material`
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
