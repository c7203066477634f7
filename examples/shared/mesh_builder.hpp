#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "scene.hpp"

namespace example {

/// Adds simple solids to a mesh; angles in radians, lengths in metres. In a mesh with texture coordinates, those of
/// quadrilaterals are metres (see quad), and those of everything else zero; set_tangents is left to the caller.
class MeshBuilder {
 public:
  explicit MeshBuilder(Mesh& mesh);

  /// Gives an empty mesh texture coordinates. A mesh that has some goes on with them anyway.
  MeshBuilder& with_texture_coordinates() {
    has_coordinates_ = true;
    return *this;
  }

  /// What is added from now on is one more of the meshes.
  MeshBuilder& begin_mesh() {
    ++mesh_number_;
    return *this;
  }

  /// The material of everything added from now on.
  MeshBuilder& use(std::uint32_t material) {
    material_ = material;
    return *this;
  }

  /// A flat quadrilateral, corners in order. Texture coordinates: two of x, y and z, those which the normal has least
  /// of, turned so that the texture is not mirrored, and upright on walls.
  void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

  void box(const glm::vec3& lower, const glm::vec3& upper);

  using Surface = std::function<glm::vec3(float u, float v)>;
  struct Grid {
    int columns;
    int rows;
    bool closed_u = false;  // u = 1 meets u = 0
    bool closed_v = false;
  };

  /// A smooth patch: position(u, v) for u and v from 0 to 1.
  void surface(const Grid& grid, const Surface& position);

  /// A solid of revolution about the vertical through `base`: smooth runs of (radius, height), with a crease
  /// between runs.
  void lathe(const glm::vec3& base, const std::vector<std::vector<glm::vec2>>& runs, int segments);

  void sphere(const glm::vec3& centre, float radius, int segments);

  /// A tube of the given radius along a closed curve, t from 0 to 1.
  void closed_tube(const std::function<glm::vec3(float t)>& curve, float radius, int segments_along,
                   int segments_around);

 private:
  std::uint32_t add_vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& coordinates = {});
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  Mesh& mesh_;
  std::uint32_t material_ = 0;
  std::uint32_t mesh_number_ = 0;
  bool has_coordinates_ = false;
};

/// A rounded profile: a Catmull-Rom curve through the points, `steps` pieces between each pair.
std::vector<glm::vec2> smooth_run(const std::vector<glm::vec2>& points, int steps);

/// A unit normal per vertex, the area-weighted mean of the triangles about it, for vertices from
/// `first_vertex` on.
void smooth_normals(Mesh& mesh, std::size_t first_vertex, std::size_t first_triangle);

}  // namespace example
