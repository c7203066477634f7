#pragma once

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "embree_api.hpp"
#include "scene.hpp"

namespace example {

/// Where a ray met a surface, as seen from the ray's origin: surfaces have two sides, and normals face the
/// origin.
struct Hit {
  glm::vec3 position;
  glm::vec3 geometric_normal;  // unit
  glm::vec3 normal;  // unit, interpolated, bent by the material's relief, less than a right angle from the way
                     // back
  float distance;    // metres
  std::uint32_t material;
  bool from_behind = false;  // met on the side that its mesh's normals turn away from
  std::uint32_t mesh = 0;    // of Mesh::triangle_meshes
  glm::vec3 tangent{0.0f};   // the x axis of an anisotropic material: along the first texture coordinate, horizontal
                             // where there is none; not of unit length
  glm::vec3 colour{1.0f};    // of the material's texture; white without one. brdf_at() has the two together
};

/// The material's BRDF at a hit, its body in the texture's colour. Where there is a texture, it is valid until the
/// thread asks again.
const zonal::Brdf& brdf_at(const Scene& scene, const Hit& hit);

/// The normal bent back where it is a right angle or more from the direction to the viewer: at silhouettes, where
/// interpolation turns it away, and on reliefs.
glm::vec3 face_viewer(const glm::vec3& normal, const glm::vec3& to_viewer);

/// Visibility in a scene, by Embree. The scene must outlive it. Safe to use from many threads.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  std::optional<Hit> closest(const glm::vec3& origin, const glm::vec3& direction) const;

  /// Leaves `from` along `direction`, which may graze the surface.
  std::optional<Hit> closest_from(const Hit& from, const glm::vec3& direction) const;

  /// Is the segment from the surface to the point free?
  bool visible(const Hit& from, const glm::vec3& point) const;
  bool visible(const Hit& from, const Hit& to) const;
  /// Is the segment between two points in free space?
  bool visible(const glm::vec3& from, const glm::vec3& to) const;

 private:
  glm::vec3 leave(const Hit& from, const glm::vec3& direction) const;

  const Scene& scene_;
  RTCDevice device_ = nullptr;
  RTCScene accelerator_ = nullptr;
  float offset_;  // metres off a surface, so that a ray does not meet its own origin
};

}  // namespace example
