// A grid as textures of four channels, 32 or 16 bits a number: what a GPU filters and reads best. (As a buffer it goes
// there as it is: CoefficientGrid::data().)
//
// A plane is a 3D texture of as many texels as the grid has vertices, x fastest. Number j of a vertex is coefficient
// j / 3, colour j % 3, in the order of Sh<N, glm::vec3>.
//
//   with gradients    plane j is number j:  (value, d/dx, d/dy, d/dz)               3 N*N planes
//   values alone      plane p is numbers 4p to 4p + 3, the last filled up with 0    (3 N*N + 3) / 4 planes
//
// So one texel holds all that an interpolation wants of a number at a vertex, or four numbers for which the texture
// unit's own linear filter is the trilinear interpolation: at texture coordinates (0.5 + cell position) / resolution.
// The planes lie one after the other: slices of one 3D texture resolution.z * planes deep (filtered it would mix
// planes, so read its texels), or textures of their own.
//
// 16 bits are IEEE halves, to nearest: a relative error of 2^-11 down to 6e-5, below it an absolute one of 3e-8; beyond
// 65504 they are 65504. What is not a number stays so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../scalar/half.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// How many planes a grid of N bands has.
template <int N, GridContent content>
constexpr int texture_plane_count(const CoefficientGrid<N, content>&) {
  return content == GridContent::values ? (3 * N * N + 3) / 4 : 3 * N * N;
}

namespace detail {

template <class Number>
Number texture_number(float x);
template <>
inline float texture_number<float>(float x) {
  return x;
}
template <>
inline std::uint16_t texture_number<std::uint16_t>(float x) {
  constexpr float most = 65504.0F;
  const float bounded = x < -most ? -most : most < x ? most : x;  // NaN stays
  return to_half(bounded).bits;
}

}  // namespace detail

/// All planes, one after the other, four numbers a texel: float, or std::uint16_t for the bits of halves.
template <class Number, int N, GridContent content>
std::vector<Number> texture_planes(const CoefficientGrid<N, content>& grid) {
  using Grid = CoefficientGrid<N, content>;
  const auto planes = static_cast<std::size_t>(texture_plane_count(grid));
  std::vector<Number> texels(4 * planes * grid.vertex_count(), Number(0));
  for (std::size_t plane = 0; plane < planes; ++plane) {
    for (std::size_t vertex = 0; vertex < grid.vertex_count(); ++vertex) {
      const float* source = grid.data() + vertex * Grid::vertex_size;
      Number* texel = texels.data() + 4 * (plane * grid.vertex_count() + vertex);
      for (std::size_t channel = 0; channel < 4; ++channel) {
        const std::size_t number = Grid::has_gradients ? channel * Grid::block_size + plane : 4 * plane + channel;
        if (number < Grid::vertex_size) texel[channel] = detail::texture_number<Number>(source[number]);
      }
    }
  }
  return texels;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
