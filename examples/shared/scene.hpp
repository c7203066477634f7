#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <zonal/material/brdf.hpp>

#include "camera.hpp"
#include "light_panel.hpp"
#include "spotlight.hpp"
#include "texture.hpp"

namespace example {

struct Material {
  std::string name;
  zonal::Brdf brdf;
  std::filesystem::path file{};  // of a measured material; else empty
  glm::vec3 emission{0.0f};      // radiance that the camera sees, and that lights nothing
  TextureMap colour{};           // what its body, the lobes of is_diffuse, reflects is multiplied by, cut to [0, 1]
  Relief relief{};
};

/// Indexed triangles with one unit normal per vertex and one material per triangle.
struct Mesh {
  std::vector<glm::vec3> positions;  // metres
  std::vector<glm::vec3> normals;
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> triangle_materials;
  std::vector<std::uint32_t> triangle_meshes;  // a number for each object or group of a file, each solid of the atrium
  /// One per vertex, or none at all. Tangents point along the first coordinate, are unit and normal to the normal; w
  /// is 1, or -1 where the texture is mirrored: the second coordinate grows along w cross(normal, tangent).
  std::vector<glm::vec2> texture_coordinates;
  std::vector<glm::vec4> tangents;
};

struct Bounds {
  glm::vec3 lower{0.0f};
  glm::vec3 upper{0.0f};

  glm::vec3 centre() const { return 0.5f * (lower + upper); }
  float radius() const { return 0.5f * glm::distance(lower, upper); }
};

struct Scene {
  std::string name;
  Mesh mesh;
  std::vector<Material> materials;
  Camera camera;
  Spotlight light;
  LightPanel panel;
  std::vector<std::string> warnings;         // what of a file is left out, a line each
  std::vector<std::filesystem::path> files;  // all that was read
};

Bounds bounds_of(const Mesh& mesh);

/// The built-in hall of columns: of matte and glossy materials, of matte ones alone, or glossy all over; the last two
/// also with rough floor, walls and stones, whose normals change from pixel to pixel. The courtyard is rough, of matte
/// and glossy materials, and open above, for a light probe to shine in.
enum class AtriumFinish { mixed, diffuse, glossy, bumped, bumped_glossy, courtyard };
Scene make_atrium(AtriumFinish finish = AtriumFinish::mixed);

/// A white sphere about its light, seen from inside. All that it reflects once is the same at all its points.
Scene make_furnace();

/// Two rooms, open in front, with a wall of 2 cm between. The lights hang in the left one; in the right one it is dark.
Scene make_rooms();

enum class UpAxis { y, z };
enum class ViewPlace { automatic, inside, outside };

/// How to show what an OBJ file holds.
struct ObjView {
  bool stage = true;      // on a floor before two walls, when seen from outside
  UpAxis up = UpAxis::y;  // of the file
  ViewPlace place = ViewPlace::automatic;
};

/// An OBJ file and its MTL, camera and light fitted to it. Throws InputError.
Scene load_obj(const std::string& path, const ObjView& view);

}  // namespace example
