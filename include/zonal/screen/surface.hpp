// What each pixel sees, and whether two pixels see one continuous surface.
//
// Only geometry decides, never the normal that a surface is shaded by: bumps are what the filter is to leave.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination, section 2.3.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/fields.hpp"
#include "../scalar/scalar.hpp"
#include "../scalar/vector3.hpp"
#include "plane_picture.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The surface that a pixel sees, one or a packet of them.
template <class T>
struct ScreenSurface {
  T position[3];
  T normal[3];  // unit, geometric
  T depth;      // > 0, a length: how far the eye is
  T mesh;       // a whole number from 0 to 2^24; below 0 there is no surface
  T material;   // the same

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(normal), visit(depth), visit(mesh), visit(material);
  }
};

/// Two pixels see the same surface if
///
///   mesh and material are the same,
///   the cosine between their normals is at least `cos_normal`,
///   each lies within `plane_distance` times the lesser depth of the other's tangent plane.
///
/// All three are symmetric. A test that is switched off always holds: cos_normal -1, plane_distance infinite.
struct SurfaceTests {
  float cos_normal = 0.8F;        // 37 degrees
  float plane_distance = 0.005F;  // of the depth: half a per cent
};

/// The test itself. No surface is the same as another, nor as itself, where there is none.
template <class T>
ZONAL_INLINE constexpr mask_t<T> is_same_surface(const ScreenSurface<T>& a, const ScreenSurface<T>& b,
                                                 const T& cos_normal, const T& plane_distance) {
  const T step[3] = {b.position[0] - a.position[0], b.position[1] - a.position[1], b.position[2] - a.position[2]};
  const T distance = maximum(abs(detail::dot3(step, a.normal)), abs(detail::dot3(step, b.normal)));
  const T identity = abs(a.mesh - b.mesh) + abs(a.material - b.material);
  // Each holds where its number is not negative.
  const T plane = plane_distance * minimum(a.depth, b.depth) - distance;
  const T cosine = detail::dot3(a.normal, b.normal) - cos_normal;
  const T least = minimum(minimum(plane, cosine), minimum(minimum(a.mesh, b.mesh), T(0.5L) - identity));
  return T(0) <= least;
}

/// The surfaces of a picture. Plane k of it is field k of ScreenSurface.
class SurfacePicture : public PlanePicture<float> {
 public:
  static constexpr int field_count = zonal::field_count<ScreenSurface<float>>;
  static constexpr std::uint32_t greatest_identity = 1U << 24U;  // what a float counts up to

  SurfacePicture() = default;
  /// No surface anywhere.
  SurfacePicture(int width, int height) : PlanePicture<float>(width, height, field_count) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) clear(x, y);
    }
  }

  /// A position that is not finite, a depth that is not above 0 and finite, and a normal that is none are no surface.
  /// Throws std::invalid_argument where mesh or material is beyond greatest_identity (refuse.hpp).
  void set_surface(int x, int y, const glm::vec3& position, const glm::vec3& geometric_normal, float depth,
                   std::uint32_t mesh, std::uint32_t material) {
    if (mesh > greatest_identity || material > greatest_identity) {
      detail::refuse("a mesh or material of a number beyond 2^24");
    }
    const ScreenSurface<float> surface{{position.x, position.y, position.z},
                                       {geometric_normal.x, geometric_normal.y, geometric_normal.z},
                                       depth,
                                       float(mesh),
                                       float(material)};
    const float length2 = glm::dot(geometric_normal, geometric_normal), reach = glm::dot(position, position);
    const bool is_surface = std::abs(length2 - 1) < 0.01F && reach <= largest && depth > 0 && depth <= largest;
    is_surface ? put(x, y, surface) : clear(x, y);
  }
  void clear(int x, int y) { put(x, y, {{0, 0, 0}, {0, 0, 0}, 1, -1, -1}); }

  bool has_surface(int x, int y) const { return get(x, y, mesh_plane) >= 0; }
  ScreenSurface<float> surface(int x, int y) const {
    ScreenSurface<float> surface{};
    int plane = 0;
    for_each_field(surface, [&](float& field) { field = get(x, y, plane++); });
    return surface;
  }

 private:
  static constexpr int mesh_plane = 7;
  static constexpr float largest = (std::numeric_limits<float>::max)();

  void put(int x, int y, ScreenSurface<float> surface) {
    int plane = 0;
    for_each_field(surface, [&](float& field) { set(x, y, plane++, field); });
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
