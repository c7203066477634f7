// Coefficients in cells of different sizes: small where they change, large where they do not.
//
// Each cell of a coarse grid may be divided into eight, and each of these, down to the cells of the fine grid that it
// is made from. Vertices are shared by the cells around them, so what costs memory are the vertices alone: 12 N*N bytes
// each, and 36 for a cell. A look-up descends to the smallest cell and interpolates there as in a CoefficientGrid.
//
// Where a small cell lies beside a large one, its vertices on their common face that are none of the large one's hang:
// they have the value that the large cell has there, and the field is continuous.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "../scalar/refuse.hpp"
#include "coefficient_grid.hpp"
#include "interpolate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

template <int N>
class AdaptiveGrid {
 public:
  using Fine = CoefficientGrid<N, GridContent::values>;
  static constexpr int bands = N;

  /// The cells of `fine`, joined 2^depth by 2^depth by 2^depth into large ones, and these divided again where their
  /// interpolation errs most, as long as there are at most `vertices`. Of no field but the fine grid's it knows
  /// nothing. Throws std::invalid_argument unless cells along each axis are a multiple of 2^depth (refuse.hpp).
  AdaptiveGrid(const Fine& fine, int depth, std::size_t vertices)
      : low_(fine.low()), high_(fine.high()), depth_(depth) {
    const bool is_depth = depth >= 0 && depth < 16;
    for (int a = 0; a < 3; ++a) {
      const int cells = fine.resolution()[a] - 1;
      if (!is_depth || cells % (1 << depth) != 0) {
        detail::refuse("a grid of " + std::to_string(cells) + " cells along an axis cannot be joined 2^" +
                       std::to_string(depth) + " by 2^" + std::to_string(depth));
      }
      roots_[a] = cells >> depth;
    }
    Builder(*this, fine).build(vertices);
  }

  const glm::vec3& low() const { return low_; }
  const glm::vec3& high() const { return high_; }
  std::size_t vertex_count() const { return data_.size() / vertex_size; }
  /// Cells that are not divided.
  std::size_t cell_count() const { return (nodes_.size() * 7 + root_count()) / 8; }
  /// Memory, of vertices and cells.
  std::size_t bytes() const { return data_.size() * sizeof(float) + nodes_.size() * sizeof(Node); }

  /// The coefficients at a position, trilinear; outside the box those of its nearest point.
  template <class Colour = glm::vec3, class Position>
  Sh<N, Colour> interpolate(const Position& position) const {
    const auto [x, y, z] = detail::as_direction<float>(position);
    const float p[3] = {x, y, z};
    float t[3];
    std::size_t node = 0, stride = 1;
    for (int a = 0; a < 3; ++a) {
      const detail::CellCoordinate place = detail::locate(p[a], low_[a], high_[a], roots_[a] + 1);
      node += stride * static_cast<std::size_t>(place.cell), stride *= static_cast<std::size_t>(roots_[a]);
      t[a] = place.t;
    }
    while (nodes_[node].child != 0) {
      std::size_t octant = 0;
      for (int a = 0; a < 3; ++a) {
        const bool is_far = t[a] >= 0.5F;
        octant |= std::size_t{is_far} << a;
        t[a] = 2 * t[a] - (is_far ? 1.0F : 0.0F);  // exact
      }
      node = nodes_[node].child + octant;
    }
    constexpr Interpolation method = Interpolation::trilinear;
    const CellWeights<method, float> weights[1] = {cell_weights<method>(
        axis_weights<method>(t[0], 1.0F), axis_weights<method>(t[1], 1.0F), axis_weights<method>(t[2], 1.0F))};
    const float* corners[8];
    for (std::size_t c = 0; c < 8; ++c) corners[c] = data_.data() + vertex_size * nodes_[node].corners[c];
    float sums[1][vertex_size];
    detail::weighted_sums<method, int{vertex_size}, 1>(corners, weights, sums);
    return detail::as_sh<Colour, N>(sums[0]);
  }

 private:
  static constexpr std::size_t vertex_size = 3 * N * N;  // floats

  struct Node {
    std::uint32_t child = 0;  // the first of eight; 0 where it is not divided
    std::array<std::uint32_t, 8> corners{};
  };

  std::size_t root_count() const { return std::size_t(roots_.x) * std::size_t(roots_.y) * std::size_t(roots_.z); }

  class Builder;

  glm::vec3 low_, high_;
  int depth_;
  glm::ivec3 roots_{0};      // undivided cells
  std::vector<Node> nodes_;  // the roots first, x fastest
  std::vector<float> data_;  // vertex after vertex
};

/// How an adaptive grid comes to be; places are in fine cells.
template <int N>
class AdaptiveGrid<N>::Builder {
 public:
  Builder(AdaptiveGrid& grid, const Fine& fine) : grid_(grid), fine_(fine), number_(fine.vertex_count(), no_vertex) {}

  void build(std::size_t vertices) {
    const int size = 1 << grid_.depth_;
    for (int k = 0; k < grid_.roots_.z; ++k) {
      for (int j = 0; j < grid_.roots_.y; ++j) {
        for (int i = 0; i < grid_.roots_.x; ++i) add({glm::ivec3(i, j, k) * size, size});
      }
    }
    for (std::uint32_t n = 0; n < cells_.size(); ++n) ask(n);
    while (!largest_error_.empty() && grid_.vertex_count() + most_new_vertices <= vertices) {
      const std::uint32_t node = largest_error_.top().node;
      largest_error_.pop();
      divide(node);
    }
    settle_hanging();
  }

 private:
  static constexpr std::uint32_t no_vertex = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr std::size_t most_new_vertices = 19;  // of a cell in eight: 27 less its corners

  struct Cell {
    glm::ivec3 place;  // its low corner
    int size;
  };
  struct Division {
    double error;
    std::uint32_t node;
    friend bool operator<(const Division& a, const Division& b) {  // of equal ones the first
      return a.error < b.error || (!(b.error < a.error) && a.node > b.node);
    }
  };

  static glm::ivec3 corner_of(const Cell& cell, std::size_t c) {
    return cell.place + glm::ivec3(int(c & 1), int(c >> 1 & 1), int(c >> 2)) * cell.size;
  }

  void add(const Cell& cell) {
    Node node;
    for (std::size_t c = 0; c < 8; ++c) node.corners[c] = vertex(corner_of(cell, c));
    grid_.nodes_.push_back(node);
    cells_.push_back(cell);
  }
  std::uint32_t vertex(const glm::ivec3& place) {
    std::uint32_t& number = number_[fine_.vertex_index(place)];
    if (number == no_vertex) {
      number = static_cast<std::uint32_t>(grid_.vertex_count());
      const float* from = fine_.data() + fine_.vertex_index(place) * vertex_size;
      grid_.data_.insert(grid_.data_.end(), from, from + vertex_size);
      places_.push_back(place);
    }
    return number;
  }

  // A cell of more than one fine cell may be divided, and its error says when.
  void ask(std::uint32_t node) {
    if (cells_[node].size > 1) largest_error_.push({error_of(cells_[node]), node});
  }
  // The sum of squares, over the fine vertices in it, of what the cell's interpolation gives less what they have.
  double error_of(const Cell& cell) const {
    const float* corners[8];
    for (std::size_t c = 0; c < 8; ++c) {
      corners[c] = fine_.data() + fine_.vertex_index(corner_of(cell, c)) * vertex_size;
    }
    double error = 0;
    for (int k = 0; k <= cell.size; ++k) {
      for (int j = 0; j <= cell.size; ++j) {
        for (int i = 0; i <= cell.size; ++i) {
          const float* at = fine_.data() + fine_.vertex_index(cell.place + glm::ivec3(i, j, k)) * vertex_size;
          float value[vertex_size];
          mix(corners, glm::vec3(i, j, k) / float(cell.size), value);
          for (std::size_t n = 0; n < vertex_size; ++n) error += double(value[n] - at[n]) * double(value[n] - at[n]);
        }
      }
    }
    return error;
  }
  static void mix(const float* const (&corners)[8], const glm::vec3& t, float (&value)[vertex_size]) {
    std::fill(value, value + vertex_size, 0.0F);
    for (std::size_t c = 0; c < 8; ++c) {
      const float weight =
          ((c & 1) != 0 ? t.x : 1 - t.x) * ((c & 2) != 0 ? t.y : 1 - t.y) * ((c & 4) != 0 ? t.z : 1 - t.z);
      for (std::size_t n = 0; n < vertex_size; ++n) value[n] += weight * corners[c][n];
    }
  }

  void divide(std::uint32_t node) {
    const Cell cell = cells_[node];
    const auto first = static_cast<std::uint32_t>(grid_.nodes_.size());
    grid_.nodes_[node].child = first;
    for (std::size_t octant = 0; octant < 8; ++octant) {
      const Cell half{cell.place, cell.size / 2};
      add({corner_of(half, octant), half.size});
    }
    for (std::uint32_t n = first; n < first + 8; ++n) ask(n);
  }

  // Vertices that hang get the value of the largest cell whose corner they are not. Large cells first: their own
  // corners are settled then.
  void settle_hanging() {
    struct Hanging {
      std::uint32_t node, vertex;
    };
    std::vector<Hanging> hanging;
    for (std::uint32_t v = 0; v < places_.size(); ++v) {
      std::uint32_t largest = no_vertex;
      for_each_cell_at(places_[v], [&](std::uint32_t node) {
        const auto& corners = grid_.nodes_[node].corners;
        if (std::find(corners.begin(), corners.end(), v) != corners.end()) return;
        if (largest == no_vertex || cells_[node].size > cells_[largest].size) largest = node;
      });
      if (largest != no_vertex) hanging.push_back({largest, v});
    }
    std::stable_sort(hanging.begin(), hanging.end(),
                     [&](const Hanging& a, const Hanging& b) { return cells_[a.node].size > cells_[b.node].size; });
    for (const Hanging& h : hanging) {
      const Cell& cell = cells_[h.node];
      const float* corners[8];
      for (std::size_t c = 0; c < 8; ++c)
        corners[c] = grid_.data_.data() + vertex_size * grid_.nodes_[h.node].corners[c];
      float value[vertex_size];
      mix(corners, glm::vec3(places_[h.vertex] - cell.place) / float(cell.size), value);
      std::copy_n(value, vertex_size, grid_.data_.data() + vertex_size * h.vertex);
    }
  }
  // The undivided cells that touch a fine vertex, some of them several times.
  template <class Visit>
  void for_each_cell_at(const glm::ivec3& place, const Visit& visit) const {
    for (int side = 0; side < 8; ++side) {
      const glm::ivec3 fine_cell = place - glm::ivec3(side & 1, side >> 1 & 1, side >> 2);
      bool is_inside = true;
      for (int a = 0; a < 3; ++a)
        is_inside = is_inside && fine_cell[a] >= 0 && fine_cell[a] < fine_.resolution()[a] - 1;
      if (is_inside) visit(cell_of(fine_cell));
    }
  }
  std::uint32_t cell_of(const glm::ivec3& fine_cell) const {
    const glm::ivec3 root = fine_cell / (1 << grid_.depth_);
    auto node = static_cast<std::uint32_t>(root.x + grid_.roots_.x * (root.y + grid_.roots_.y * root.z));
    while (grid_.nodes_[node].child != 0) {
      const int half = cells_[node].size / 2;
      const glm::ivec3 far = (fine_cell - cells_[node].place) / half;
      node = grid_.nodes_[node].child + static_cast<std::uint32_t>(far.x + 2 * far.y + 4 * far.z);
    }
    return node;
  }

  AdaptiveGrid& grid_;
  const Fine& fine_;
  std::vector<std::uint32_t> number_;  // of each fine vertex, among those kept
  std::vector<glm::ivec3> places_;     // of those kept
  std::vector<Cell> cells_;            // of each node
  std::priority_queue<Division> largest_error_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
