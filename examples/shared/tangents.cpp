#include "tangents.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace example {
namespace {

/// Where a triangle's first texture coordinate grows, as a unit vector, and whether its texture is mirrored: 1 or -1,
/// or 0 where the coordinates do not say.
struct TextureDirection {
  glm::vec3 tangent{0.0f};
  int turn = 0;
};

TextureDirection texture_direction(const Mesh& mesh, const glm::uvec3& triangle) {
  // In double: differences of large coordinates, and their products, may be small.
  const auto edge = [&](int k) { return glm::dvec3(mesh.positions[triangle[k]] - mesh.positions[triangle.x]); };
  const auto step = [&](int k) {
    return glm::dvec2(mesh.texture_coordinates[triangle[k]]) - glm::dvec2(mesh.texture_coordinates[triangle.x]);
  };
  const glm::dvec2 b = step(1), c = step(2);
  const double area = b.x * c.y - b.y * c.x;
  const double size = glm::length(b) * glm::length(c);
  if (!(std::abs(area) > 1e-9 * size)) return {};
  const glm::dvec3 tangent = (c.y * edge(1) - b.y * edge(2)) / area;
  const double length = glm::length(tangent);
  if (!(length > 0.0) || !std::isfinite(length)) return {};
  return {tangent / length, area < 0.0 ? -1 : 1};
}

float angle_at(const Mesh& mesh, const glm::uvec3& triangle, int corner) {
  const glm::vec3& at = mesh.positions[triangle[corner]];
  const glm::vec3 a = mesh.positions[triangle[(corner + 1) % 3]] - at;
  const glm::vec3 b = mesh.positions[triangle[(corner + 2) % 3]] - at;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::vec3 part_along(const glm::vec3& normal, const glm::vec3& v) { return v - glm::dot(v, normal) * normal; }

/// Gives the triangles that turn the other way than the first about a vertex a copy of it; returns each vertex's turn.
std::vector<int> split_mirrored(Mesh& mesh, const std::vector<TextureDirection>& directions) {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::vector<int> turns(mesh.positions.size(), 0);
  std::vector<std::uint32_t> mirrored(mesh.positions.size(), none);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int turn = directions[t].turn;
    for (int k = 0; turn != 0 && k < 3; ++k) {
      std::uint32_t& vertex = mesh.triangles[t][k];
      if (turns[vertex] == 0) turns[vertex] = turn;
      if (turns[vertex] == turn) continue;
      if (mirrored[vertex] == none) {
        mirrored[vertex] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
        mesh.normals.push_back(glm::vec3(mesh.normals[vertex]));
        mesh.texture_coordinates.push_back(glm::vec2(mesh.texture_coordinates[vertex]));
        turns.push_back(turn);
      }
      vertex = mirrored[vertex];
    }
  }
  return turns;
}

}  // namespace

glm::vec3 horizontal_tangent(const glm::vec3& normal) {
  const glm::vec3 horizontal(normal.z, 0.0f, -normal.x);
  return glm::dot(horizontal, horizontal) > 1e-6f ? horizontal : glm::vec3(1.0f, 0.0f, 0.0f);
}

void set_tangents(Mesh& mesh) {
  if (mesh.texture_coordinates.empty()) return;
  std::vector<TextureDirection> directions;
  directions.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) directions.push_back(texture_direction(mesh, triangle));
  const std::vector<int> turns = split_mirrored(mesh, directions);
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0.0f));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[t][k];
      const glm::vec3 along = part_along(mesh.normals[vertex], directions[t].tangent);
      const float length = glm::length(along);
      if (length > 1e-6f) sums[vertex] += angle_at(mesh, mesh.triangles[t], k) / length * along;
    }
  }
  mesh.tangents.resize(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < sums.size(); ++vertex) {
    const glm::vec3& normal = mesh.normals[vertex];
    const bool known = glm::length(sums[vertex]) > 1e-6f;
    const glm::vec3 tangent = part_along(normal, known ? sums[vertex] : horizontal_tangent(normal));
    mesh.tangents[vertex] = glm::vec4(glm::normalize(tangent), turns[vertex] < 0 ? -1.0f : 1.0f);
  }
}

}  // namespace example
