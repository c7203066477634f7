// Coefficients at the vertices of a regular grid over a box, with their spatial gradients or without.
//
// All is one array of floats: vertex after vertex, x fastest, then y; per vertex four blocks side by side, the value
// and its derivatives by x, y and z, or the value's block alone; per block 3 N*N floats in the order of Sh<N,
// glm::vec3>, coefficient by coefficient, RGB innermost. An interpolation weighs all floats of a block alike, so any
// order within a block vectorises as well, and this one is what goes in and out. Blocks of a vertex adjoin because the
// interpolations that use gradients read all four, and so do vertices along x: a cell is four runs of memory.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/gradient.hpp"
#include "../scalar/refuse.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a grid has at its vertices. Gradients are what Hermite and Taylor interpolation need.
enum class GridContent { values, values_and_gradients };

/// N bands of RGB coefficients and their gradients, per unit of length, at resolution.x * .y * .z vertices, the
/// outermost on the faces of the box from `low` to `high`. 48 N*N bytes per vertex, without gradients 12 N*N, and no
/// more. Vertices are named by (i, j, k), from 0.
template <int N, GridContent grid_content = GridContent::values_and_gradients>
class CoefficientGrid {
 public:
  static constexpr int bands = N;
  static constexpr GridContent content = grid_content;
  static constexpr bool has_gradients = content == GridContent::values_and_gradients;
  static constexpr int block_size = 3 * N * N;               // floats
  static constexpr int block_count = has_gradients ? 4 : 1;  // value, d/dx, d/dy, d/dz
  static constexpr int vertex_size = block_count * block_size;

  /// All coefficients 0. Throws std::invalid_argument unless the box is finite, low < high on every axis, and there are
  /// at least 2 vertices on each, few enough to lie apart in float; without exceptions it ends the program
  /// (refuse.hpp), so ask what_is_wrong first.
  CoefficientGrid(const glm::vec3& low, const glm::vec3& high, const glm::ivec3& resolution)
      : low_(low), high_(high), resolution_(resolution) {
    const std::string wrong = what_is_wrong(low, high, resolution);
    if (!wrong.empty()) detail::refuse(wrong);
    spacing_ = (high - low) / glm::vec3(resolution - 1);
    data_.resize(vertex_size * static_cast<std::size_t>(resolution.x) * static_cast<std::size_t>(resolution.y) *
                 static_cast<std::size_t>(resolution.z));
  }

  /// Why there can be no such grid; empty if there can be one.
  static std::string what_is_wrong(const glm::vec3& low, const glm::vec3& high, const glm::ivec3& resolution) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string wrong = what_is_wrong("xyz"[axis], low[axis], high[axis], resolution[axis]);
      if (!wrong.empty()) return wrong;
    }
    std::size_t size = vertex_size;
    for (int axis = 0; axis < 3; ++axis) {
      const auto count = static_cast<std::size_t>(resolution[axis]);
      if (size > std::vector<float>().max_size() / count) {
        return "a grid of " + std::to_string(resolution.x) + " x " + std::to_string(resolution.y) + " x " +
               std::to_string(resolution.z) + " vertices is more than memory can hold";
      }
      size *= count;
    }
    return {};
  }

  const glm::vec3& low() const { return low_; }
  const glm::vec3& high() const { return high_; }
  /// Vertices per axis.
  const glm::ivec3& resolution() const { return resolution_; }
  /// The size of a cell.
  const glm::vec3& spacing() const { return spacing_; }

  std::size_t vertex_count() const { return data_.size() / vertex_size; }
  /// Where a vertex stands among all: i + resolution.x * (j + resolution.y * k).
  std::size_t vertex_index(const glm::ivec3& vertex) const {
    for (int axis = 0; axis < 3; ++axis) assert(0 <= vertex[axis] && vertex[axis] < resolution_[axis]);
    const auto size = [](int count) { return static_cast<std::size_t>(count); };
    return size(vertex.x) + size(resolution_.x) * (size(vertex.y) + size(resolution_.y) * size(vertex.z));
  }
  /// The last vertex of an axis lies on `high` exactly.
  glm::vec3 position(const glm::ivec3& vertex) const {
    const glm::vec3 inner = low_ + glm::vec3(vertex) * spacing_;
    glm::vec3 place;
    for (int a = 0; a < 3; ++a) place[a] = vertex[a] == resolution_[a] - 1 ? high_[a] : inner[a];
    return place;
  }

  Sh<N, glm::vec3> value(const glm::ivec3& vertex) const { return block(vertex, 0); }
  ShGradient<N, glm::vec3> value_with_gradient(const glm::ivec3& vertex) const {
    static_assert(has_gradients, "a grid of values alone has no gradients");
    return {block(vertex, 0), {block(vertex, 1), block(vertex, 2), block(vertex, 3)}};
  }
  /// A gradient that is there stays as it is.
  void set(const glm::ivec3& vertex, const Sh<N, glm::vec3>& value) { set_block(vertex, 0, value); }
  void set(const glm::ivec3& vertex, const ShGradient<N, glm::vec3>& coefficients) {
    static_assert(has_gradients, "a grid of values alone has no gradients");
    set_block(vertex, 0, coefficients.value);
    for (int axis = 0; axis < 3; ++axis) set_block(vertex, axis + 1, coefficients.gradient[axis]);
  }

  /// All floats, in the order stated at the top; vertex number v begins at v * vertex_size.
  float* data() { return data_.data(); }
  const float* data() const { return data_.data(); }
  /// How many there are: vertex_count() * vertex_size.
  std::size_t size() const { return data_.size(); }

 private:
  // The same of one axis.
  static std::string what_is_wrong(char axis, float low, float high, int vertices) {
    const std::string name = std::string("the grid's ") + axis + " axis ";
    if (vertices < 2) return name + "has " + std::to_string(vertices) + " vertices; it needs at least 2";
    const std::string range = "from " + std::to_string(low) + " to " + std::to_string(high);
    if (!std::isfinite(low) || !std::isfinite(high) || !std::isfinite(high - low)) {
      return name + "goes " + range + ", which is not finite";
    }
    if (!(low < high)) return name + "goes " + range + ", which leaves no space between";
    const float step = (high - low) / static_cast<float>(vertices - 1);
    if (!(low < low + step) || !(high - step < high) || !std::isfinite(1 / step)) {
      return name + "has " + std::to_string(vertices) + " vertices " + range + ", too close to tell apart in float";
    }
    return {};
  }

  std::size_t block_begin(const glm::ivec3& vertex, int number) const {
    return vertex_index(vertex) * vertex_size + static_cast<std::size_t>(number * block_size);
  }
  Sh<N, glm::vec3> block(const glm::ivec3& vertex, int number) const {
    const float* source = data_.data() + block_begin(vertex, number);
    Sh<N, glm::vec3> sh;
    for (int i = 0; i < N * N; ++i) sh[i] = {source[3 * i], source[3 * i + 1], source[3 * i + 2]};
    return sh;
  }
  void set_block(const glm::ivec3& vertex, int number, const Sh<N, glm::vec3>& sh) {
    float* target = data_.data() + block_begin(vertex, number);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) target[3 * i + c] = sh[i][c];
    }
  }

  glm::vec3 low_, high_, spacing_;
  glm::ivec3 resolution_;
  std::vector<float> data_;
};

/// The grid without its gradients.
template <int N>
CoefficientGrid<N, GridContent::values> values_of(const CoefficientGrid<N>& grid) {
  CoefficientGrid<N, GridContent::values> values(grid.low(), grid.high(), grid.resolution());
  const float* source = grid.data();
  for (float* target = values.data(); target < values.data() + values.size(); target += values.vertex_size) {
    for (int i = 0; i < values.block_size; ++i) target[i] = source[i];
    source += grid.vertex_size;
  }
  return values;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
