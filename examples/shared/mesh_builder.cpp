#include "mesh_builder.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace example {
namespace {

/// See MeshBuilder::quad.
glm::vec2 flat_coordinates(const glm::vec3& position, const glm::vec3& normal) {
  const glm::vec3 size = glm::abs(normal);
  if (size.y >= std::max(size.x, size.z)) return {position.x, normal.y < 0.0f ? position.z : -position.z};
  if (size.x >= size.z) return {normal.x < 0.0f ? position.z : -position.z, position.y};
  return {normal.z < 0.0f ? -position.x : position.x, position.y};
}

}  // namespace

MeshBuilder::MeshBuilder(Mesh& mesh) : mesh_(mesh), has_coordinates_(!mesh.texture_coordinates.empty()) {
  for (const std::uint32_t number : mesh.triangle_meshes) mesh_number_ = std::max(mesh_number_, number + 1);
}

std::uint32_t MeshBuilder::add_vertex(const glm::vec3& position, const glm::vec3& normal,
                                      const glm::vec2& coordinates) {
  mesh_.positions.push_back(position);
  mesh_.normals.push_back(normal);
  if (has_coordinates_) mesh_.texture_coordinates.push_back(coordinates);
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  // At the poles of a patch two corners coincide: such a triangle has no area and no normal.
  const glm::vec3& origin = mesh_.positions[a];
  const glm::vec3 area = glm::cross(mesh_.positions[b] - origin, mesh_.positions[c] - origin);
  if (glm::dot(area, area) < 1e-18f) return;
  mesh_.triangles.emplace_back(a, b, c);
  mesh_.triangle_materials.push_back(material_);
  mesh_.triangle_meshes.push_back(mesh_number_);
}

void MeshBuilder::quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  const glm::vec3 normal = glm::normalize(glm::cross(c - a, d - b));
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const glm::vec3& corner : {a, b, c, d}) add_vertex(corner, normal, flat_coordinates(corner, normal));
  add_triangle(first, first + 1, first + 2);
  add_triangle(first, first + 2, first + 3);
}

void MeshBuilder::box(const glm::vec3& lower, const glm::vec3& upper) {
  const auto corner = [&](int x, int y, int z) {
    return glm::vec3(x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z);
  };
  quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  quad(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
  quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
  quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  quad(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
  quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
}

void MeshBuilder::surface(const Grid& grid, const Surface& position) {
  const std::size_t first_triangle = mesh_.triangles.size();
  const int columns = grid.closed_u ? grid.columns : grid.columns + 1;
  const int rows = grid.closed_v ? grid.rows : grid.rows + 1;
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float u = static_cast<float>(column) / static_cast<float>(grid.columns);
      const float v = static_cast<float>(row) / static_cast<float>(grid.rows);
      add_vertex(position(u, v), glm::vec3(0.0f));
    }
  }
  const auto index = [&](int column, int row) {
    return first + static_cast<std::uint32_t>((row % rows) * columns + column % columns);
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      add_triangle(index(column, row), index(column + 1, row), index(column + 1, row + 1));
      add_triangle(index(column, row), index(column + 1, row + 1), index(column, row + 1));
    }
  }
  smooth_normals(mesh_, first, first_triangle);
}

void MeshBuilder::lathe(const glm::vec3& base, const std::vector<std::vector<glm::vec2>>& runs, int segments) {
  for (const std::vector<glm::vec2>& run : runs) {
    const int pieces = static_cast<int>(run.size()) - 1;
    surface({segments, pieces, true, false}, [&](float u, float v) {
      const auto point = static_cast<std::size_t>(std::lround(v * static_cast<float>(pieces)));
      const glm::vec2 profile = run[point];
      const float angle = -glm::two_pi<float>() * u;
      return base + glm::vec3(profile.x * std::cos(angle), profile.y, profile.x * std::sin(angle));
    });
  }
}

void MeshBuilder::sphere(const glm::vec3& centre, float radius, int segments) {
  surface({segments, segments / 2, true, false}, [&](float u, float v) {
    const float phi = -glm::two_pi<float>() * u;
    const float theta = glm::pi<float>() * (1.0f - v);
    const glm::vec3 unit(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    return centre + radius * unit;
  });
}

void MeshBuilder::closed_tube(const std::function<glm::vec3(float)>& curve, float radius, int segments_along,
                              int segments_around) {
  const float step = 0.5f / static_cast<float>(segments_along);
  surface({segments_around, segments_along, true, true}, [&](float u, float v) {
    const glm::vec3 centre = curve(v);
    const glm::vec3 ahead = curve(v + step);
    const glm::vec3 behind = curve(v - step);
    const glm::vec3 tangent = glm::normalize(ahead - behind);
    // Towards the centre of curvature: turns smoothly along any curve that bends everywhere.
    const glm::vec3 bend = ahead + behind - 2.0f * centre;
    const glm::vec3 side = glm::normalize(bend - tangent * glm::dot(bend, tangent));
    const glm::vec3 other = glm::cross(tangent, side);
    const float angle = glm::two_pi<float>() * u;
    return centre + radius * (std::cos(angle) * side + std::sin(angle) * other);
  });
}

std::vector<glm::vec2> smooth_run(const std::vector<glm::vec2>& points, int steps) {
  std::vector<glm::vec2> run{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::vec2 p1 = points[i];
    const glm::vec2 p2 = points[i + 1];
    const glm::vec2 p0 = i == 0 ? 2.0f * p1 - p2 : points[i - 1];
    const glm::vec2 p3 = i + 2 < points.size() ? points[i + 2] : 2.0f * p2 - p1;
    for (int step = 1; step <= steps; ++step) {
      const float t = static_cast<float>(step) / static_cast<float>(steps);
      const glm::vec2 cubic = (3.0f * (p1 - p2) + p3 - p0) * t + (2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3);
      run.push_back(0.5f * ((cubic * t + (p2 - p0)) * t + 2.0f * p1));
    }
  }
  return run;
}

void smooth_normals(Mesh& mesh, std::size_t first_vertex, std::size_t first_triangle) {
  for (std::size_t t = first_triangle; t < mesh.triangles.size(); ++t) {
    const glm::uvec3 triangle = mesh.triangles[t];
    const glm::vec3 origin = mesh.positions[triangle.x];
    const glm::vec3 area = glm::cross(mesh.positions[triangle.y] - origin, mesh.positions[triangle.z] - origin);
    for (int corner = 0; corner < 3; ++corner) mesh.normals[triangle[corner]] += area;
  }
  for (std::size_t v = first_vertex; v < mesh.normals.size(); ++v) {
    const float length = glm::length(mesh.normals[v]);
    mesh.normals[v] = length > 0.0f ? mesh.normals[v] / length : glm::vec3(0.0f, 1.0f, 0.0f);
  }
}

}  // namespace example
