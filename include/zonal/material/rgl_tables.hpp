// The tables of an RGL material file (rgl.hpp): functions on the unit square, and the map that makes one uniform.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/index.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// A place between two of several nodes, as fractions of the first and of the second.
struct NodePair {
  std::size_t below, above;
  double t;
};

/// Nodes increase; beyond the ends t is 0 or 1.
inline NodePair node_pair(const std::vector<float>& nodes, double x) {
  if (nodes.size() == 1) return {0, 0, 0.0};
  const auto after =
      std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x, [](double a, float b) { return a < double(b); });
  const auto above = static_cast<std::size_t>(after - nodes.begin());
  const double low = double(nodes[above - 1]), high = double(nodes[above]);
  return {above - 1, above, std::clamp((x - low) / (high - low), 0.0, 1.0)};
}

/// Of the functions tabulated at nodes of phi and theta, those around a place that have a weight, at most four.
struct SliceBlend {
  std::array<std::size_t, 4> slice{};
  std::array<double, 4> weight{};
  std::size_t count = 0;

  void add(std::size_t one, double its_weight) {
    if (detail::is_equal(its_weight, 0.0)) return;
    slice[count] = one;
    weight[count++] = its_weight;
  }
};

inline SliceBlend slice_blend(const NodePair& phi, const NodePair& theta, std::size_t theta_count) {
  const double p = phi.t, t = theta.t;
  SliceBlend blend;
  blend.add(phi.below * theta_count + theta.below, (1.0 - p) * (1.0 - t));
  blend.add(phi.below * theta_count + theta.above, (1.0 - p) * t);
  blend.add(phi.above * theta_count + theta.below, p * (1.0 - t));
  blend.add(phi.above * theta_count + theta.above, p * t);
  return blend;
}

/// A cell of a grid on the unit square, and a place in it, in [0, 1]^2.
struct GridCell {
  std::size_t column, row;
  double x, y;
};

struct GridShape {
  std::size_t rows, columns;

  std::size_t size() const { return rows * columns; }
  std::size_t index(std::size_t row, std::size_t column) const { return row * columns + column; }

  GridCell cell(const glm::dvec2& u) const {
    const auto axis = [](double place, std::size_t count) {
      const double x = place > 0.0 ? (std::min)(place, 1.0) * double(count - 1) : 0.0;
      const auto below = static_cast<std::size_t>(index_below(x, static_cast<int>(count) - 2));
      return std::pair(below, x - double(below));
    };
    const auto [column, x] = axis(u.x, columns);
    const auto [row, y] = axis(u.y, rows);
    return {column, row, x, y};
  }
};

inline double mix(double a, double b, double t) { return a + t * (b - a); }

/// A function on the unit square.
struct SquareFunction {
  GridShape shape;
  std::vector<float> values;

  double operator()(const glm::dvec2& u) const {
    const GridCell c = shape.cell(u);
    const auto at = [&](std::size_t row, std::size_t column) { return double(values[shape.index(row, column)]); };
    return mix(mix(at(c.row, c.column), at(c.row, c.column + 1), c.x),
               mix(at(c.row + 1, c.column), at(c.row + 1, c.column + 1), c.x), c.y);
  }
};

/// Densities on the unit square, one per slice, and the map of each that makes it uniform. Negative values count as
/// zero. Throws std::invalid_argument where a density is zero everywhere.
class SquareWarp {
 public:
  SquareWarp() = default;
  SquareWarp(GridShape shape, std::vector<float> density) : shape_(shape), density_(std::move(density)) {
    const std::size_t slices = density_.size() / shape_.size();
    along_row_.resize(density_.size());
    rows_.resize(slices * shape_.rows);
    for (std::size_t slice = 0; slice < slices; ++slice) accumulate(slice);
  }

  /// Where the square's place u goes: the mass of the rows below it, and along its row, of the blended density. Both
  /// are sums of the slices' own, for a cumulative distribution is linear in its density.
  glm::dvec2 operator()(const glm::dvec2& u, const SliceBlend& blend) const {
    const GridCell c = shape_.cell(u);
    const auto across = [&](const std::vector<float>& values, std::size_t column) {
      return mix(blended(values, shape_.size(), shape_.index(c.row, column), blend),
                 blended(values, shape_.size(), shape_.index(c.row + 1, column), blend), c.y);
    };
    const double left = across(density_, c.column), right = across(density_, c.column + 1);
    const double mass = across(along_row_, c.column) + c.x * (left + 0.5 * c.x * (right - left));
    const double row_mass = across(along_row_, shape_.columns - 1);

    const std::size_t last = shape_.columns - 1;
    const double low = blended(along_row_, shape_.size(), shape_.index(c.row, last), blend);
    const double high = blended(along_row_, shape_.size(), shape_.index(c.row + 1, last), blend);
    const double below = blended(rows_, shape_.rows, c.row, blend) + c.y * (low + 0.5 * c.y * (high - low));
    // an empty row: any place of it will do
    return {row_mass > 0.0 ? mass / row_mass : u.x, below};
  }

  const GridShape& shape() const { return shape_; }
  std::size_t slices() const { return density_.size() / (std::max<std::size_t>)(shape_.size(), 1); }
  /// The density of a slice, over its total, in units of a cell.
  const float* density(std::size_t slice) const { return density_.data() + slice * shape_.size(); }

 private:
  static double blended(const std::vector<float>& values, std::size_t stride, std::size_t index,
                        const SliceBlend& blend) {
    double sum = 0.0;
    for (std::size_t i = 0; i < blend.count; ++i)
      sum += blend.weight[i] * double(values[blend.slice[i] * stride + index]);
    return sum;
  }

  void accumulate(std::size_t slice) {
    float* const density = density_.data() + slice * shape_.size();
    float* const along_row = along_row_.data() + slice * shape_.size();
    float* const rows = rows_.data() + slice * shape_.rows;
    std::vector<double> sums(shape_.size()), row_sums(shape_.rows);
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      density[i] = (std::max)(density[i], 0.0F);
      if (i % shape_.columns != 0) sums[i] = sums[i - 1] + 0.5 * (double(density[i - 1]) + double(density[i]));
    }
    const auto row_mass = [&](std::size_t row) { return sums[shape_.index(row, shape_.columns - 1)]; };
    for (std::size_t row = 1; row < shape_.rows; ++row) {
      row_sums[row] = row_sums[row - 1] + 0.5 * (row_mass(row - 1) + row_mass(row));
    }
    const double total = row_sums.back();
    if (!(total > 0.0)) throw std::invalid_argument("a density of vndf is zero everywhere");
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      density[i] = float(double(density[i]) / total);
      along_row[i] = float(sums[i] / total);
    }
    for (std::size_t row = 0; row < shape_.rows; ++row) rows[row] = float(row_sums[row] / total);
  }

  GridShape shape_{};
  // of each slice, over its total: the density, its integral along the row up to there, that of the rows before; all
  // in units of a cell
  std::vector<float> density_, along_row_, rows_;
};

inline double polar_angle(const glm::dvec3& v) { return std::atan2(std::hypot(v.x, v.y), v.z); }
inline double azimuth(const glm::dvec3& v) { return std::atan2(v.y, v.x); }

/// The place of a direction on the unit square; phi of any turn.
inline glm::dvec2 square_place(double theta, double phi) {
  const double turn = (phi + double(kPi)) / (2.0 * double(kPi));
  return {std::sqrt(theta * 2.0 / double(kPi)), turn - std::floor(turn)};
}

}  // namespace detail

/// The arrays of a material, as the file has them: see rgl.hpp.
struct RglArrays {
  std::string description;
  bool jacobian = true;
  std::vector<float> phi, theta;
  detail::SquareFunction sigma, ndf;
  detail::SquareWarp vndf;
  detail::GridShape rgb_shape{};
  std::vector<float> rgb;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
