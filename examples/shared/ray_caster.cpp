#include "ray_caster.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <variant>

#include "frame.hpp"
#include "tangents.hpp"

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

template <class Value>
Value interpolated(const std::vector<Value>& values, const glm::uvec3& triangle, const glm::vec2& place) {
  return (1.0f - place.x - place.y) * values[triangle.x] + place.x * values[triangle.y] + place.y * values[triangle.z];
}

/// What of a triangle with texture coordinates a hit needs. Normals here are those of the mesh, whichever side is seen.
class TexturedTriangle {
 public:
  TexturedTriangle(const Mesh& mesh, const glm::uvec3& corners, const glm::vec2& place)
      : mesh_(mesh),
        corners_(corners),
        coordinates_(interpolated(mesh.texture_coordinates, corners, place)),
        tangent_(interpolated(mesh.tangents, corners, place)) {}

  const glm::vec2& coordinates() const { return coordinates_; }
  glm::vec3 tangent() const { return tangent_; }

  glm::vec3 bent(const glm::vec3& normal, const Relief& relief) const {
    return relief.kind == Relief::Kind::normals ? by_normals(normal, relief) : by_heights(normal, relief);
  }

 private:
  glm::vec3 by_normals(const glm::vec3& normal, const Relief& relief) const {
    glm::vec3 local = 2.0f * relief.map.at(coordinates_) - 1.0f;
    local.x *= relief.strength;
    local.y *= relief.strength * (tangent_.w < 0.0f ? -1.0f : 1.0f);
    local.z = std::max(local.z, 1e-3f);  // none points into the surface
    return glm::normalize(Frame(normal, tangent_).to_world(local));
  }

  /// The normal of the surface that stands out by the heights along its normals: of the height, only what it grows by
  /// along the surface counts.
  glm::vec3 by_heights(const glm::vec3& normal, const Relief& relief) const {
    const glm::vec3& a = mesh_.positions[corners_.x];
    const glm::vec3 edge_b = mesh_.positions[corners_.y] - a, edge_c = mesh_.positions[corners_.z] - a;
    const glm::vec2 step_b = mesh_.texture_coordinates[corners_.y] - mesh_.texture_coordinates[corners_.x];
    const glm::vec2 step_c = mesh_.texture_coordinates[corners_.z] - mesh_.texture_coordinates[corners_.x];
    const glm::vec2 growth = relief.strength * relief.map.gradient(coordinates_);
    // The gradient in the triangle's plane whose products with the edges are the steps along them.
    const glm::vec3 area = glm::cross(edge_b, edge_c);
    const glm::vec3 gradient =
        (glm::dot(growth, step_b) * glm::cross(edge_c, area) + glm::dot(growth, step_c) * glm::cross(area, edge_b)) /
        glm::dot(area, area);
    return glm::normalize(normal - (gradient - glm::dot(gradient, normal) * normal));
  }

  const Mesh& mesh_;
  const glm::uvec3& corners_;
  glm::vec2 coordinates_;
  glm::vec4 tangent_;
};

Hit make_hit(const Scene& scene, const RTCRayHit& found, const glm::vec3& direction) {
  const Mesh& mesh = scene.mesh;
  const glm::uvec3& triangle = mesh.triangles[found.hit.primID];
  const glm::vec2 place(found.hit.u, found.hit.v);
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3 edge_b = mesh.positions[triangle.y] - a;
  const glm::vec3 edge_c = mesh.positions[triangle.z] - a;
  const glm::vec3 geometric = glm::normalize(glm::cross(edge_b, edge_c));
  const float side = glm::dot(geometric, direction) > 0.0f ? -1.0f : 1.0f;
  glm::vec3 normal = interpolated(mesh.normals, triangle, place);
  const float length = glm::length(normal);
  // Normals that cancel, or that oppose their own triangle (careless files), are worth less than the plane's.
  const bool from_behind = glm::dot(length > 1e-6f ? normal : geometric, direction) > 0.0f;
  const bool usable = length > 1e-6f && glm::dot(normal, geometric) > 0.0f;
  normal = usable ? normal / length : geometric;
  Hit hit{};
  hit.position = a + place.x * edge_b + place.y * edge_c;
  hit.geometric_normal = side * geometric;
  hit.distance = found.ray.tfar;
  hit.from_behind = from_behind;
  hit.material = mesh.triangle_materials[found.hit.primID];
  hit.mesh = mesh.triangle_meshes[found.hit.primID];
  if (mesh.texture_coordinates.empty()) {
    hit.normal = face_viewer(side * normal, -direction);
    hit.tangent = horizontal_tangent(hit.normal);
    return hit;
  }
  const TexturedTriangle textured(mesh, triangle, place);
  const Material& material = scene.materials[hit.material];
  if (material.colour) hit.colour = glm::clamp(material.colour.at(textured.coordinates()), 0.0f, 1.0f);
  if (material.relief) normal = textured.bent(normal, material.relief);
  hit.normal = face_viewer(side * normal, -direction);
  hit.tangent = textured.tangent();
  return hit;
}

void multiply_body(zonal::LambertBrdf& lobe, const glm::vec3& colour) { lobe.albedo *= colour; }
void multiply_body(zonal::ResidualBrdf& lobe, const glm::vec3& colour) { lobe.albedo *= colour; }
template <class Lobe>
void multiply_body(Lobe&, const glm::vec3&) {}

}  // namespace

const zonal::Brdf& brdf_at(const Scene& scene, const Hit& hit) {
  const Material& material = scene.materials[hit.material];
  if (!material.colour) return material.brdf;
  thread_local zonal::Brdf coloured;  // it keeps its memory
  coloured.lobes.assign(material.brdf.lobes.begin(), material.brdf.lobes.end());
  for (zonal::BrdfLobe& lobe : coloured.lobes) {
    std::visit([&](auto& model) { multiply_body(model, hit.colour); }, lobe);
  }
  return coloured;
}

glm::vec3 face_viewer(const glm::vec3& normal, const glm::vec3& to_viewer) {
  constexpr float least_cosine = 1e-3f;
  const float cosine = glm::dot(normal, to_viewer);
  return cosine >= least_cosine ? normal : glm::normalize(normal + (least_cosine - cosine) * to_viewer);
}

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
  return make_hit(scene_, query, direction);
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
  return visible(leave(from, point - from.position), point);
}

bool RayCaster::visible(const glm::vec3& from, const glm::vec3& to) const {
  RTCRay ray = make_ray(from, to - from, 1.0f - 1e-5f);
  embree::occluded(accelerator_, ray);
  return ray.tfar >= 0.0f;
}

bool RayCaster::visible(const Hit& from, const Hit& to) const {
  return visible(from, leave(to, from.position - to.position));
}

}  // namespace example
