// Coefficients anywhere in a grid, from the vertices of the cell around: trilinear, first-order Taylor and Hermite.
//
// A lookup finds the cell, computes the weights of its 8 corners (interpolation_weights.hpp, where the three are
// compared), and adds up the corners' blocks: one sum over 8 or 32 terms for all coefficients and colours.
//
// Positions are anything with p[0], p[1] and p[2], or p.x, p.y and p.z; colours, anything made of three floats in
// braces.
//
// Outside the box the interpolant is that of the nearest point of the box, constant along the face's normal: there the
// gradient's component across the face is 0. On the face itself it is the inside's. On a face between cells, where a
// component may jump, it is that of the cell above. A coordinate that is not a number makes all results NaN; one that
// is infinite lies outside.
//
// In float the weights are exact to a few ulp; the position within a cell, as any difference to `low`, to an ulp of the
// number of cells that lie below it.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "../scalar/index.hpp"
#include "../scalar/lanes.hpp"
#include "../scalar/unroll.hpp"
#include "../scalar/vector3.hpp"
#include "coefficient_grid.hpp"
#include "interpolation_weights.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// Where a coordinate lies on an axis: in which cell, at which t in it, and dt/dx.
struct CellCoordinate {
  int cell;
  float t, rate;
};
inline CellCoordinate locate(float x, float low, float high, int vertices) {
  const float count = static_cast<float>(vertices), rate = cell_rate(low, high, count);
  const float inside = cell_position(x, low, rate, count);  // NaN stays
  const int cell = index_below(inside, vertices - 2);
  const float t = minimum(inside - static_cast<float>(cell), 1.0F);
  return {cell, t, x < low || high < x ? 0.0F : rate};
}

// A cell of the grid, and the position in it.
struct CellLookup {
  const float* corners[8];
  float size[3], t[3], rate[3];

  template <class Grid, class Position>
  CellLookup(const Grid& grid, const Position& position) {
    const auto [x, y, z] = as_direction<float>(position);
    const glm::vec3 p(x, y, z), spacing = grid.spacing();
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis) {
      const CellCoordinate place = locate(p[axis], grid.low()[axis], grid.high()[axis], grid.resolution()[axis]);
      cell[axis] = place.cell;
      size[axis] = spacing[axis];
      t[axis] = place.t;
      rate[axis] = place.rate;
    }
    const auto first = grid.vertex_index(cell), above = static_cast<std::size_t>(grid.resolution().x);
    const auto behind = above * static_cast<std::size_t>(grid.resolution().y);
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t vertex = first + (c & 1) + (c >> 1 & 1) * above + (c >> 2) * behind;
      corners[c] = grid.data() + vertex * Grid::vertex_size;
    }
  }
};

// The lanes in which `count` consecutive floats are best summed: the last vector overlaps the one before.
constexpr int lanes_for(int count) {
  int lanes = kNativeLanes;
  while (lanes > count) lanes /= 2;
  return lanes < 4 ? 1 : lanes;
}

// sums[o] = sum over corners and blocks of weights[o] times the corner's block of Count floats.
template <Interpolation method, int Count, int Outputs>
ZONAL_INLINE inline void weighted_sums(const float* const (&corners)[8],
                                       const CellWeights<method, float> (&weights)[std::size_t{Outputs}],
                                       float (&sums)[std::size_t{Outputs}][std::size_t{Count}]) {
  constexpr int lanes = lanes_for(Count), vectors = (Count + lanes - 1) / lanes;
  constexpr int together = Outputs == 1 ? 6 : 2;  // so that all sums stay in registers
  using Floats = Lanes<float, lanes>;
  // The sums of `size` vectors from float `begin` on, number i of which begins at(i) floats later.
  const auto sum_vectors = [&](auto size, int begin, auto at) ZONAL_INLINE {
    Floats partial[static_cast<std::size_t>(Outputs)][static_cast<std::size_t>(size())];
    for (auto& output : partial) {
      for (Floats& sum : output) sum = Floats(0);
    }
    for (int c = 0; c < 8; ++c) {
      const float* const corner = corners[c] + begin;
      unroll<0, blocks_read(method)>([&](auto block) ZONAL_INLINE {
        Floats weight[static_cast<std::size_t>(Outputs)];
        for (int o = 0; o < Outputs; ++o) weight[o] = Floats(weights[o].corner[c][block]);
        unroll<0, size()>([&](auto i) ZONAL_INLINE {
          const Floats data = Floats::load(corner + (block * Count + at(i)));
          for (int o = 0; o < Outputs; ++o) partial[o][i].add_product(weight[o], data);
        });
      });
    }
    for (int o = 0; o < Outputs; ++o) {
      for (int i = 0; i < size; ++i) partial[o][i].store(sums[o] + begin + at(i));
    }
  };
  constexpr int last = (vectors - 1) / together * together;  // the first vector of the last ones
  for (int first = 0; first < last; first += together) {
    sum_vectors(Index<together>{}, first * lanes, [](int i) ZONAL_INLINE { return i * lanes; });
  }
  sum_vectors(Index<vectors - last>{}, last * lanes, [](int i) ZONAL_INLINE {
    return (last + i) * lanes < Count - lanes ? i * lanes : Count - lanes - last * lanes;
  });
}

template <class Colour, int N>
ZONAL_INLINE inline Sh<N, Colour> as_sh(const float (&values)[std::size_t{3 * N * N}]) {
  Sh<N, Colour> sh;
  for (int i = 0; i < N * N; ++i) sh[i] = Colour{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  return sh;
}

}  // namespace detail

/// The coefficients at a position, interpolated.
template <Interpolation method, class Colour = glm::vec3, int N, GridContent content, class Position>
Sh<N, Colour> interpolate(const CoefficientGrid<N, content>& grid, const Position& position) {
  static_assert(blocks_read(method) <= CoefficientGrid<N, content>::block_count,
                "a grid of values alone interpolates trilinearly");
  const detail::CellLookup at(grid, position);
  const CellWeights<method, float> weights[1] = {cell_weights<method>(axis_weights<method>(at.t[0], at.size[0]),
                                                                      axis_weights<method>(at.t[1], at.size[1]),
                                                                      axis_weights<method>(at.t[2], at.size[2]))};
  float sums[1][static_cast<std::size_t>(3 * N * N)];
  detail::weighted_sums<method, 3 * N * N, 1>(at.corners, weights, sums);
  return detail::as_sh<Colour, N>(sums[0]);
}

/// The same, and the interpolant's own gradient, exactly: d/dx, d/dy and d/dz of the interpolated coefficients, per
/// unit of length. (Not the interpolated gradient: the two agree at the vertices only, and for trilinear not even
/// there.)
template <Interpolation method, class Colour = glm::vec3, int N, GridContent content, class Position>
ShGradient<N, Colour> interpolate_with_gradient(const CoefficientGrid<N, content>& grid, const Position& position) {
  static_assert(blocks_read(method) <= CoefficientGrid<N, content>::block_count,
                "a grid of values alone interpolates trilinearly");
  const detail::CellLookup at(grid, position);
  AxisWeights<float> axis[3], slope[3];
  for (int a = 0; a < 3; ++a) {
    axis[a] = axis_weights<method>(at.t[a], at.size[a]);
    slope[a] = axis_weight_derivatives<method>(at.t[a], at.size[a], at.rate[a]);
  }
  const CellWeights<method, float> weights[4] = {
      cell_weights<method>(axis[0], axis[1], axis[2]), cell_weights<method>(slope[0], axis[1], axis[2]),
      cell_weights<method>(axis[0], slope[1], axis[2]), cell_weights<method>(axis[0], axis[1], slope[2])};
  float sums[4][static_cast<std::size_t>(3 * N * N)];
  detail::weighted_sums<method, 3 * N * N, 4>(at.corners, weights, sums);
  const auto sh = [&](int i) { return detail::as_sh<Colour, N>(sums[i]); };
  return {sh(0), {sh(1), sh(2), sh(3)}};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
