// What the vertices of a grid see: for each, whether it lies inside geometry, where it was moved to, and how near
// geometry is in every direction.
//
// All is one array of floats, vertex after vertex in the order of CoefficientGrid, 4 + 2 (2 rings + 1)^2
// each:
//
//   0 to 2   offset: by how much the vertex was moved; its coefficients are those of position + offset
//   3        1, or 0 of a vertex inside geometry, which counts only where all corners of a cell do
//   4 on     the nodes of an octahedral map, (2 rings + 1)^2, row by row: nearness and its variance, > 0
//            (visibility_weights.hpp). Node (i, j) from the middle is the place (i, j) / rings of the square of
//            environment/octahedral.hpp; on its rim every direction stands twice, those of (i, j) with |i| = rings
//            also at (i, -j), those with |j| = rings at (-i, j)
//
// 664 bytes a vertex with the usual 4 rings. measure_visibility.hpp fills it from rays.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "../scalar/index.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Vertices are named by their number, CoefficientGrid::vertex_index.
class GridVisibility {
 public:
  static constexpr int default_rings = 4;

  /// Of no grid: nothing is known, and interpolations are plain.
  GridVisibility() = default;
  /// For grids of this box and resolution; of all vertices nothing is known: each sees everything. rings >= 1. Refuses
  /// the boxes that CoefficientGrid refuses, and as it does.
  GridVisibility(const glm::vec3& low, const glm::vec3& high, const glm::ivec3& resolution, int rings = default_rings)
      : low_(low), high_(high), resolution_(resolution), rings_(rings) {
    const std::string wrong = CoefficientGrid<1, GridContent::values>::what_is_wrong(low, high, resolution);
    if (!wrong.empty()) detail::refuse(wrong);
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) count *= static_cast<std::size_t>(resolution[axis]);
    data_.resize(count * vertex_size());
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
      set_place(vertex, glm::vec3(0), false);
      for (int node = 0; node < node_count(); ++node) set_node(vertex, node, 0, 1);
    }
  }
  template <int N, GridContent content>
  explicit GridVisibility(const CoefficientGrid<N, content>& grid, int rings = default_rings)
      : GridVisibility(grid.low(), grid.high(), grid.resolution(), rings) {}

  bool empty() const { return data_.empty(); }
  const glm::vec3& low() const { return low_; }
  const glm::vec3& high() const { return high_; }
  const glm::ivec3& resolution() const { return resolution_; }
  /// Of nodes about the middle of a vertex's map.
  int rings() const { return rings_; }
  /// Nodes of a map.
  int node_count() const { return (2 * rings_ + 1) * (2 * rings_ + 1); }
  /// Is it of a grid like this?
  template <int N, GridContent content>
  bool fits(const CoefficientGrid<N, content>& grid) const {
    return !empty() && low_ == grid.low() && high_ == grid.high() && resolution_ == grid.resolution();
  }

  bool is_buried(std::size_t vertex) const { return !(of(vertex)[3] > 0); }
  /// Where the vertex was moved from its position in the grid, and where its coefficients belong.
  glm::vec3 offset(std::size_t vertex) const { return {of(vertex)[0], of(vertex)[1], of(vertex)[2]}; }
  void set_place(std::size_t vertex, const glm::vec3& offset, bool is_buried) {
    float* const numbers = data_.data() + vertex * vertex_size();
    for (int axis = 0; axis < 3; ++axis) numbers[axis] = offset[axis];
    numbers[3] = is_buried ? 0.0F : 1.0F;
  }
  void set_node(std::size_t vertex, int node, float nearness, float variance) {
    float* const numbers = data_.data() + vertex * vertex_size() + 4 + 2 * node;
    numbers[0] = nearness, numbers[1] = variance;
  }

  /// All floats, in the order stated at the top.
  float* data() { return data_.data(); }
  const float* data() const { return data_.data(); }
  std::size_t size() const { return data_.size(); }
  /// Floats of a vertex.
  std::size_t vertex_size() const { return 4 + 2 * static_cast<std::size_t>(node_count()); }
  std::size_t vertex_count() const { return data_.size() / vertex_size(); }

 private:
  const float* of(std::size_t vertex) const { return data_.data() + vertex * vertex_size(); }

  glm::vec3 low_{0}, high_{0};
  glm::ivec3 resolution_{0};
  int rings_ = default_rings;
  std::vector<float> data_;
};

namespace detail {

/// The four nodes about a place, in the order of NodeWeights, and where it lies between. What is no number reads those
/// of the middle, and x and y stay none.
struct MapNodes {
  int node[4];
  float x, y;

  MapNodes(float column, float row, int rings) {
    const Along across(column, rings), down(row, rings);
    x = across.fraction, y = down.fraction;
    const int side = 2 * rings + 1, middle = 2 * rings * (rings + 1);
    for (int i = 0; i < 4; ++i) node[i] = middle + across.node[i % 2] + side * down.node[i / 2];
  }

 private:
  // The node towards the middle, and that away from it.
  struct Along {
    int node[2];
    float fraction;
    Along(float place, int rings) {
      const float distance = abs(place);
      const int inner = index_below(distance, rings - 1);
      const int sign = place < 0 ? -1 : 1;
      node[0] = sign * inner, node[1] = sign * (inner + 1);
      fraction = distance - static_cast<float>(inner);
    }
  };
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
