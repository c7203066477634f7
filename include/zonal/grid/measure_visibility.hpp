// The visibility of a grid's vertices (visibility.hpp) by rays, which the caller traces: the library has no geometry.
//
// A vertex lies inside geometry where more than a quarter of all directions meet surfaces from behind [1]. It is then
// moved out, past the nearest of these, and any vertex nearer to a surface than a tenth of the cell's shortest side is
// moved away from it, or past its back, as long as it stays within 0.45 of a cell of its place on each axis; a vertex
// that is still inside counts as buried. So surfaces need a front: of closed solids, and of rooms seen from within.
// What has none is never met from behind; a vertex inside of it is no vertex that sees anything, which is nearly as
// good.
//
// [1] Majercik et al., Scaling probe-based real-time dynamic global illumination for production, JCGT 10(2), 2021.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "../environment/octahedral.hpp"
#include "visibility.hpp"
#include "visibility_weights.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a ray meets first: how far away, infinity if nothing, and whether it is the back of a surface.
struct RayHit {
  float distance = std::numeric_limits<float>::infinity();
  bool is_back_face = false;
};

namespace detail {

/// A vertex on its way out of geometry, and what it sees in the end.
template <class Trace>
class VertexView {
 public:
  VertexView(const glm::vec3& position, const glm::vec3& cell, const Trace& trace)
      : place_(position), cell_(cell), shortest_((std::min)({cell.x, cell.y, cell.z})), trace_(trace) {}

  /// Moves the vertex, and says whether it stays inside geometry.
  void find_place(glm::vec3& offset, bool& is_buried) const {
    constexpr int most_steps = 6;
    offset = glm::vec3(0);
    Surroundings around = look_around(offset);
    for (int step = 0; step < most_steps && around.is_crowded; ++step) {
      const glm::vec3 next = offset + around.way_out;
      const glm::vec3 share = glm::abs(next) / cell_;
      if (!((std::max)({share.x, share.y, share.z}) <= 0.45F)) break;
      offset = next;
      around = look_around(offset);
    }
    is_buried = around.is_inside;
  }

  /// The map, from `offset` off the vertex: what a ray meets at each node, and how far off that is between.
  void measure(const glm::vec3& offset, std::size_t vertex, GridVisibility& visibility) const {
    const int rings = visibility.rings(), side = 2 * rings, rays = side * rays_per_node;
    const auto nodes = static_cast<std::size_t>(visibility.node_count());
    const Octahedral at_nodes(side, side), between(rays, rays);
    std::vector<double> nearness(nodes), weight(nodes, 0), squares(nodes, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
      nearness[i] = this->nearness(offset, at_nodes.direction(int(i) % (side + 1), int(i) / (side + 1)));
    }
    for (int i = 0; i < rays * rays; ++i) {
      const double column = i % rays + 0.5, row = i / rays + 0.5;
      const MapNodes at(float(column / rays_per_node - rings), float(row / rays_per_node - rings), rings);
      const NodeWeights<double> weights = node_weights(double(at.x), double(at.y));
      double rest = this->nearness(offset, between.direction(column, row));
      for (int k = 0; k < 4; ++k) rest -= weights.weight[k] * nearness[std::size_t(at.node[k])];
      for (int k = 0; k < 4; ++k) {
        const std::size_t node = first_of_its_direction(at.node[k], rings);
        weight[node] += weights.weight[k];
        squares[node] += weights.weight[k] * rest * rest;
      }
    }
    // A quarter, as measured (visibility_weights.hpp). The rays are not all there are: a hundredth of the distance is
    // never known, nor a thousandth of the cell's.
    const double least = 1e-3 / double(cell_.x + cell_.y + cell_.z);
    for (std::size_t i = 0; i < nodes; ++i) {
      const std::size_t node = first_of_its_direction(int(i), rings);
      const double variance = 0.25 * squares[node] / weight[node] + 1e-4 * nearness[i] * nearness[i] + least * least;
      visibility.set_node(vertex, int(i), float(nearness[i]), float(variance));
    }
  }

 private:
  static constexpr int rays_per_node = 6;  // along each axis

  /// Of the nodes on the rim with one direction, one.
  static std::size_t first_of_its_direction(int node, int rings) {
    const int side = 2 * rings + 1;
    int column = node % side - rings, row = node / side - rings;
    if (std::abs(column) == rings) row = std::abs(row);
    if (std::abs(row) == rings) column = std::abs(column);
    return static_cast<std::size_t>(column + rings + side * (row + rings));
  }

  struct Surroundings {
    bool is_inside, is_crowded;  // inside geometry; or too near to it
    glm::vec3 way_out;
  };
  Surroundings look_around(const glm::vec3& offset) const {
    constexpr int side = 16;
    const Octahedral map(side, side);
    const float margin = 0.1F * shortest_;
    float behind = std::numeric_limits<float>::infinity(), before = behind;  // the nearest back and front
    glm::vec3 to_behind(0), to_before(0);
    double inside = 0;
    for (int i = 0; i < side * side; ++i) {
      const glm::vec3 direction = as_vector(map.direction(i % side + 0.5, i / side + 0.5));
      const auto hit = trace_(place_ + offset, direction);
      if (hit.is_back_face) inside += map.solid_angle(i % side, i / side);
      float& nearest = hit.is_back_face ? behind : before;
      if (hit.distance < nearest) {
        nearest = hit.distance;
        (hit.is_back_face ? to_behind : to_before) = direction;
      }
    }
    const bool is_inside = inside > map.covered() / 4;
    if (is_inside || behind < (std::min)(before, margin)) return {is_inside, true, to_behind * (behind + margin)};
    return {false, before < margin, to_before * (before - 1.01F * margin)};
  }

  /// At most that of a twentieth of the cell's shortest side.
  double nearness(const glm::vec3& offset, const std::array<double, 3>& along) const {
    const glm::vec3 direction = as_vector(along), size = glm::abs(direction);
    const float most = 20 / shortest_, distance = trace_(place_ + offset, direction).distance;
    const float q = 1 / (distance * (size.x + size.y + size.z));
    return double(distance > 0 && q < most ? q : most);
  }

  static glm::vec3 as_vector(const std::array<double, 3>& v) { return {float(v[0]), float(v[1]), float(v[2])}; }

  glm::vec3 place_, cell_;
  float shortest_;
  const Trace& trace_;
};

}  // namespace detail

/// What the vertices of a grid see. trace(origin, direction), the direction a unit glm::vec3, gives what a ray meets,
/// as RayHit does; for_each(count, body) calls body(0) to body(count - 1), in any order, on as many threads as it
/// likes, and what comes out does not depend on it. 256 rays a vertex and step, and 144 rings^2 + (2 rings + 1)^2:
/// 2385.
template <int N, GridContent content, class Trace, class ForEach>
GridVisibility measure_visibility(const CoefficientGrid<N, content>& grid, const Trace& trace, const ForEach& for_each,
                                  int rings = GridVisibility::default_rings) {
  GridVisibility visibility(grid, rings);
  const glm::ivec3 resolution = grid.resolution();
  for_each(resolution.y * resolution.z, [&](int row) {
    for (int i = 0; i < resolution.x; ++i) {
      const glm::ivec3 vertex(i, row % resolution.y, row / resolution.y);
      const std::size_t number = grid.vertex_index(vertex);
      const detail::VertexView<Trace> view(grid.position(vertex), grid.spacing(), trace);
      glm::vec3 offset;
      bool is_buried = false;
      view.find_place(offset, is_buried);
      visibility.set_place(number, offset, is_buried);
      view.measure(offset, number, visibility);
    }
  });
  return visibility;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
