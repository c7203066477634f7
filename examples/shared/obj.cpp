// Scenes from Wavefront OBJ files.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include <tiny_obj_loader.h>
#include <glm/gtc/constants.hpp>

#include "input_error.hpp"
#include "materials.hpp"
#include "mesh_builder.hpp"
#include "obj_check.hpp"

namespace example {
namespace {

constexpr float least_roughness = 0.03f;
// Without normals, faces that meet at less than 60 degrees are one smooth surface.
constexpr float cos_crease = 0.5f;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// GGX alpha: the PBR extension's perceptual roughness squared, or what has the width of a Phong exponent.
float ggx_roughness(const tinyobj::material_t& source) {
  const float roughness = source.roughness > 0.0f ? source.roughness * source.roughness
                                                  : std::sqrt(2.0f / (std::max(source.shininess, 0.0f) + 2.0f));
  return std::clamp(roughness, least_roughness, 1.0f);
}

Material make_material(const tinyobj::material_t& source) {
  const glm::vec3 specular =
      glm::clamp(glm::vec3(source.specular[0], source.specular[1], source.specular[2]), 0.0f, 1.0f);
  const glm::vec3 given = glm::clamp(glm::vec3(source.diffuse[0], source.diffuse[1], source.diffuse[2]), 0.0f, 1.0f);
  // Many files reflect more than they receive.
  const glm::vec3 diffuse = glm::min(given, 1.0f - specular);
  Material material{source.name, {}};
  if (diffuse != glm::vec3(0.0f)) material.brdf.lobes.push_back(zonal::LambertBrdf{diffuse});
  if (specular != glm::vec3(0.0f)) {
    material.brdf.lobes.push_back(zonal::GgxBrdf{ggx_roughness(source), zonal::SchlickFresnel{specular}});
  }
  return material;
}

/// Copies triangles out of tinyobjloader, each pair of position and normal once.
class ObjMesh {
 public:
  ObjMesh(const tinyobj::ObjReader& source, Mesh& mesh)
      : source_(source.GetAttrib()), mesh_(mesh), areas_at_(source_.vertices.size() / 3) {
    for_each_face(source, [this](const tinyobj::index_t* corners, int) {
      for (int i = 0; i < 3; ++i) areas_at_[static_cast<std::size_t>(corners[i].vertex_index)].push_back(area(corners));
    });
  }

  void copy(const tinyobj::ObjReader& source, std::uint32_t default_material) {
    for_each_face(source, [&](const tinyobj::index_t* corners, int material) {
      glm::uvec3 triangle{};
      for (int i = 0; i < 3; ++i) {
        const std::optional<glm::vec3> given = normal(corners[i]);
        triangle[i] = vertex(position(corners[i]), given ? *given : creased_normal(corners[i], area(corners)));
      }
      mesh_.triangles.push_back(triangle);
      mesh_.triangle_materials.push_back(material < 0 ? default_material : static_cast<std::uint32_t>(material));
    });
  }

 private:
  /// body(three corners, material) for every triangle that has an area.
  template <class Body>
  void for_each_face(const tinyobj::ObjReader& source, const Body& body) const {
    for (const tinyobj::shape_t& shape : source.GetShapes()) {
      for (std::size_t face = 0; 3 * face + 2 < shape.mesh.indices.size(); ++face) {
        const tinyobj::index_t* corners = &shape.mesh.indices[3 * face];
        const glm::vec3 face_area = area(corners);
        if (glm::dot(face_area, face_area) > 0.0f) body(corners, shape.mesh.material_ids[face]);
      }
    }
  }

  /// Along the normal, twice as long as the triangle is large.
  glm::vec3 area(const tinyobj::index_t* corners) const {
    const glm::vec3 origin = position(corners[0]);
    return glm::cross(position(corners[1]) - origin, position(corners[2]) - origin);
  }

  /// The area-weighted mean over the faces about a vertex that go on smoothly from the face at hand.
  glm::vec3 creased_normal(const tinyobj::index_t& corner, const glm::vec3& face_area) const {
    const glm::vec3 flat = glm::normalize(face_area);
    glm::vec3 sum(0.0f);
    for (const glm::vec3& other : areas_at_[static_cast<std::size_t>(corner.vertex_index)]) {
      if (glm::dot(flat, glm::normalize(other)) > cos_crease) sum += other;
    }
    return glm::normalize(sum);
  }

  glm::vec3 position(const tinyobj::index_t& corner) const {
    const auto first = 3 * static_cast<std::size_t>(corner.vertex_index);
    if (corner.vertex_index < 0 || first + 2 >= source_.vertices.size())
      throw InputError("a face names a vertex that is not there");
    return {source_.vertices[first], source_.vertices[first + 1], source_.vertices[first + 2]};
  }

  std::optional<glm::vec3> normal(const tinyobj::index_t& corner) const {
    const auto first = 3 * static_cast<std::size_t>(corner.normal_index);
    if (corner.normal_index < 0 || first + 2 >= source_.normals.size()) return std::nullopt;
    const glm::vec3 given(source_.normals[first], source_.normals[first + 1], source_.normals[first + 2]);
    const float length = glm::length(given);
    if (!(length > 1e-6f) || !std::isfinite(length)) return std::nullopt;
    return given / length;
  }

  std::uint32_t vertex(const glm::vec3& point, const glm::vec3& normal) {
    const auto key = std::make_tuple(point.x, point.y, point.z, normal.x, normal.y, normal.z);
    const auto [entry, added] = vertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (added) {
      mesh_.positions.push_back(point);
      mesh_.normals.push_back(normal);
    }
    return entry->second;
  }

  const tinyobj::attrib_t& source_;
  Mesh& mesh_;
  std::vector<std::vector<glm::vec3>> areas_at_;  // of the faces about each vertex of the file
  std::map<std::tuple<float, float, float, float, float, float>, std::uint32_t> vertices_;
};

void fit_view(Scene& scene, const Bounds& bounds) {
  const float radius = bounds.radius();
  const glm::vec3 centre = bounds.centre();
  scene.camera.target = centre;
  scene.camera.vertical_field_of_view = glm::radians(40.0f);
  scene.camera.position = centre + 3.3f * radius * glm::normalize(glm::vec3(0.35f, 0.30f, 1.0f));
  scene.light.position = centre + 3.2f * radius * glm::normalize(glm::vec3(-0.75f, 0.85f, 0.65f));
  scene.light.axis = glm::normalize(centre - scene.light.position);
  scene.light.half_angle = glm::radians(54.0f);
  scene.light.edge = 0.5f;
  const glm::vec3 across = glm::normalize(glm::cross(scene.light.axis, glm::vec3(0.0f, 1.0f, 0.0f)));
  const float distance = glm::distance(centre, scene.light.position);
  scene.panel = {scene.light.position, radius * across, radius * glm::cross(across, scene.light.axis), distance};
  // White surfaces that face the light at the target reflect a radiance of about 1.
  scene.light.intensity = glm::vec3(glm::pi<float>() * distance * distance);
}

/// A floor under the object, a wall behind it, and a coloured wall on the side away from the light.
void add_stage(Scene& scene, const Bounds& bounds) {
  const auto floor = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({"stage floor", matte({0.72f, 0.70f, 0.66f})});
  scene.materials.push_back({"stage back wall", matte({0.30f, 0.45f, 0.66f})});
  scene.materials.push_back({"stage side wall", matte({0.74f, 0.30f, 0.14f})});
  const float size = 5.0f * bounds.radius();
  const float ground = bounds.lower.y;
  const float back = bounds.lower.z - 0.5f * bounds.radius();
  const float side = bounds.upper.x + 0.9f * bounds.radius();
  const float front = bounds.upper.z + size;
  const float left = bounds.lower.x - size;
  MeshBuilder builder(scene.mesh);
  builder.use(floor).quad({left, ground, front}, {side, ground, front}, {side, ground, back}, {left, ground, back});
  builder.use(floor + 1).quad({left, ground, back}, {side, ground, back}, {side, ground + size, back},
                              {left, ground + size, back});
  builder.use(floor + 2).quad({side, ground, back}, {side, ground, front}, {side, ground + size, front},
                              {side, ground + size, back});
}

tinyobj::ObjReader read_obj(const std::string& path) {
  check_is_file(path);
  const std::string material_file = check_obj(path);
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  config.vertex_color = false;
  if (!reader.ParseFromFile(path, config)) {
    throw InputError(path + ": cannot be read as OBJ" +
                     (reader.Error().empty() ? "" : " (" + first_line(reader.Error()) + ")"));
  }
  if (!material_file.empty() && reader.GetMaterials().empty()) {
    throw InputError(path + ": its material file " + material_file + " is missing or has no materials");
  }
  return reader;
}

/// What of the file the scene leaves out, a line each.
std::vector<std::string> losses(const std::string& path, const tinyobj::ObjReader& reader) {
  std::vector<std::string> lines;
  if (!reader.Warning().empty()) lines.push_back(path + ": " + first_line(reader.Warning()));
  const auto has_more = [](const tinyobj::material_t& material) {
    const glm::vec3 emission(material.emission[0], material.emission[1], material.emission[2]);
    return !material.diffuse_texname.empty() || emission != glm::vec3(0.0f);
  };
  const std::vector<tinyobj::material_t>& materials = reader.GetMaterials();
  if (std::any_of(materials.begin(), materials.end(), has_more)) {
    lines.push_back(path + ": textures and emission are left out");
  }
  return lines;
}

}  // namespace

Scene load_obj(const std::string& path, bool stage) {
  const tinyobj::ObjReader reader = read_obj(path);
  Scene scene;
  scene.name = std::filesystem::path(path).filename().string();
  for (const tinyobj::material_t& source : reader.GetMaterials()) scene.materials.push_back(make_material(source));
  const auto default_material = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({"default", matte(glm::vec3(0.7f))});
  try {
    ObjMesh(reader, scene.mesh).copy(reader, default_material);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  if (scene.mesh.triangles.empty()) throw InputError(path + ": no triangles in it");
  const Bounds bounds = bounds_of(scene.mesh);
  fit_view(scene, bounds);
  if (stage) add_stage(scene, bounds);
  scene.warnings = losses(path, reader);
  scene.files = {path};
  return scene;
}

}  // namespace example
