#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mtl_file.hpp"

namespace example {

/// What an OBJ file and its material files hold, in the file's own coordinates.
struct ObjFile {
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  struct Corner {
    std::uint32_t vertex;
    std::uint32_t coordinates;  // or none
    std::uint32_t normal;       // or none
  };
  struct Triangle {
    std::array<Corner, 3> corners;
    std::uint32_t material;  // or none
    std::int32_t smoothing;  // its smoothing group: 0 is flat, -1 where the file has not said
    std::uint32_t mesh;      // a number for each pair of names of an object and of groups, in the file's order
  };

  std::vector<glm::dvec3> positions;
  std::vector<glm::vec2> texture_coordinates;
  std::vector<glm::vec3> normals;   // of any length
  std::vector<Triangle> triangles;  // some may be without area
  std::vector<MtlMaterial> materials;
  std::vector<std::filesystem::path> material_files;
  std::vector<std::string> warnings;  // what is missing or left out, a line each
};

/// Reads a Wavefront OBJ file as programs really write it: byte order marks, continued lines, comments behind anything,
/// names of files and materials with blanks, faces of any number of corners. Throws InputError with the line.
///
/// By hand, since tinyobjloader keeps coordinates as float, which far from the origin are wrong before anything can be
/// done about it, has at most 255 corners in a face, and cuts the names of materials at their first blank.
ObjFile read_obj(const std::string& path);

}  // namespace example
