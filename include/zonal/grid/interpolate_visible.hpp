// Coefficients at a surface in a grid, from the corners of the cell that it sees (visibility_weights.hpp).
//
// As interpolate.hpp, but for what is said here. A look-up reads 48 bytes more of each corner, at three places, and
// computes its share: 220 ns for 31 by trilinear weights of 3 bands, 270 for 75 by Hermite's.
#pragma once

#include <cassert>
#include <cstddef>

#include "interpolate.hpp"
#include "visibility.hpp"
#include "visibility_weights.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The share of a corner, 0 to 1, of a receiver at this place.
inline float share_of(const GridVisibility& visibility, std::size_t vertex, const float (&to_receiver)[3]) {
  const float* const numbers = visibility.data() + vertex * visibility.vertex_size();
  const MapPlace<float> place = map_place(to_receiver, static_cast<float>(visibility.rings()));
  const MapNodes at(place.column, place.row, visibility.rings());
  float mean[4], variance[4];
  for (int i = 0; i < 4; ++i) {
    mean[i] = numbers[4 + 2 * at.node[i]];
    variance[i] = numbers[5 + 2 * at.node[i]];
  }
  return numbers[3] * seen_share(place.nearness, mean, variance, at.x, at.y);
}

}  // namespace detail

/// The coefficients at a position on a surface with this unit normal, the side that is lit; normal 0 where there is no
/// surface. `visibility` is empty, and the interpolation plain, or fits the grid. A normal that is not a number makes
/// all results NaN, as a position does.
template <Interpolation method, class Colour = glm::vec3, int N, GridContent content, class Position, class Normal>
Sh<N, Colour> interpolate(const CoefficientGrid<N, content>& grid, const GridVisibility& visibility,
                          const Position& position, const Normal& normal) {
  static_assert(blocks_read(method) <= CoefficientGrid<N, content>::block_count,
                "a grid of values alone interpolates trilinearly");
  if (visibility.empty()) return interpolate<method, Colour>(grid, position);
  assert(visibility.fits(grid));
  const detail::CellLookup at(grid, position);
  const auto [x, y, z] = detail::as_direction<float>(normal);
  const float n[3] = {x, y, z};
  float seen[8];
  for (std::size_t c = 0; c < 8; ++c) {
    const auto vertex =
        static_cast<std::size_t>(at.corners[c] - grid.data()) / CoefficientGrid<N, content>::vertex_size;
    const float* const offset = visibility.data() + vertex * visibility.vertex_size();
    const float corner[3] = {float(c & 1), float(c >> 1 & 1), float(c >> 2)};
    float to_receiver[3];
    from_corner(at.t, at.size, corner, {offset[0], offset[1], offset[2]}, n, to_receiver);
    seen[c] = detail::share_of(visibility, vertex, to_receiver);
  }
  AxisWeights<float> axis[3];
  for (int a = 0; a < 3; ++a) axis[a] = axis_weights<method>(at.t[a], at.size[a]);
  const CellWeights<method, float> weights[1] = {
      visible_weights(cell_weights<method>(axis[0], axis[1], axis[2]), axis, seen)};
  float sums[1][static_cast<std::size_t>(3 * N * N)];
  detail::weighted_sums<method, 3 * N * N, 1>(at.corners, weights, sums);
  return detail::as_sh<Colour, N>(sums[0]);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
