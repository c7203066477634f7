#include "ray_caster.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace example {
namespace {

RTCRay make_ray(const glm::vec3& origin, const glm::vec3& direction, float end) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = 0.0f;
  ray.tfar = end;
  ray.mask = std::numeric_limits<unsigned>::max();
  return ray;
}

/// The normal bent back towards the viewer where interpolation turned it away, at silhouettes.
glm::vec3 face_viewer(const glm::vec3& normal, const glm::vec3& to_viewer) {
  constexpr float least_cosine = 1e-3f;
  const float cosine = glm::dot(normal, to_viewer);
  return cosine >= least_cosine ? normal : glm::normalize(normal + (least_cosine - cosine) * to_viewer);
}

glm::vec3 interpolated_normal(const Mesh& mesh, const glm::uvec3& triangle, float u, float v) {
  return (1.0f - u - v) * mesh.normals[triangle.x] + u * mesh.normals[triangle.y] + v * mesh.normals[triangle.z];
}

/// The x axis of the surface's own frame: horizontal, counter-clockwise seen from above (y is up); where the surface is
/// level, along x. Materials are thus brushed around the vertical axis.
glm::vec3 surface_tangent(const glm::vec3& normal) {
  const glm::vec3 horizontal(normal.z, 0.0f, -normal.x);
  return glm::dot(horizontal, horizontal) > 1e-6f ? horizontal : glm::vec3(1.0f, 0.0f, 0.0f);
}

Hit make_hit(const Mesh& mesh, const RTCRayHit& found, const glm::vec3& direction) {
  const glm::uvec3 triangle = mesh.triangles[found.hit.primID];
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3 edge_b = mesh.positions[triangle.y] - a;
  const glm::vec3 edge_c = mesh.positions[triangle.z] - a;
  const glm::vec3 geometric = glm::normalize(glm::cross(edge_b, edge_c));
  const float side = glm::dot(geometric, direction) > 0.0f ? -1.0f : 1.0f;
  glm::vec3 normal = interpolated_normal(mesh, triangle, found.hit.u, found.hit.v);
  const float length = glm::length(normal);
  // Normals that cancel, or that oppose their own triangle (careless files), are worth less than the plane's.
  const bool from_behind = glm::dot(length > 1e-6f ? normal : geometric, direction) > 0.0f;
  const bool usable = length > 1e-6f && glm::dot(normal, geometric) > 0.0f;
  normal = usable ? normal / length : geometric;
  Hit hit{};
  hit.position = a + found.hit.u * edge_b + found.hit.v * edge_c;
  hit.geometric_normal = side * geometric;
  hit.normal = face_viewer(side * normal, -direction);
  hit.distance = found.ray.tfar;
  hit.from_behind = from_behind;
  hit.material = mesh.triangle_materials[found.hit.primID];
  hit.tangent = surface_tangent(hit.normal);
  return hit;
}

}  // namespace

RayCaster::RayCaster(const Scene& scene) : scene_(scene) {
  const Mesh& mesh = scene.mesh;
  const Bounds bounds = bounds_of(mesh);
  const glm::vec3 extent = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
  offset_ = 2e-5f * std::max({extent.x, extent.y, extent.z, 1e-6f});

  device_ = rtcNewDevice(nullptr);
  if (device_ == nullptr) throw std::runtime_error("Embree found no device");
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes at a vertex, so it gets its own padded copy.
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                           mesh.positions.size());
  std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(vertices));
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                          mesh.triangles.size());
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<glm::uvec3*>(indices));
  rtcCommitGeometry(geometry);

  accelerator_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(accelerator_, RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(accelerator_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(accelerator_);
}

RayCaster::~RayCaster() {
  rtcReleaseScene(accelerator_);
  rtcReleaseDevice(device_);
}

std::optional<Hit> RayCaster::closest(const glm::vec3& origin, const glm::vec3& direction) const {
  RTCRayHit query{};
  query.ray = make_ray(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(accelerator_, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return make_hit(scene_.mesh, query, direction);
}

glm::vec3 RayCaster::leave(const Hit& from, const glm::vec3& direction) const {
  const float side = glm::dot(direction, from.geometric_normal) < 0.0f ? -1.0f : 1.0f;
  return from.position + side * offset_ * from.geometric_normal;
}

std::optional<Hit> RayCaster::closest_from(const Hit& from, const glm::vec3& direction) const {
  return closest(leave(from, direction), direction);
}

bool RayCaster::visible(const Hit& from, const glm::vec3& point) const {
  // Light that comes in behind the triangle is no light, whatever the interpolated normal says.
  if (glm::dot(point - from.position, from.geometric_normal) <= 0.0f) return false;
  const glm::vec3 origin = leave(from, point - from.position);
  RTCRay ray = make_ray(origin, point - origin, 1.0f - 1e-5f);
  embree::occluded(accelerator_, ray);
  return ray.tfar >= 0.0f;
}

bool RayCaster::visible(const Hit& from, const Hit& to) const {
  return visible(from, leave(to, from.position - to.position));
}

}  // namespace example
