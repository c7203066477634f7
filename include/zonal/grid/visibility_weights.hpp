// What of a cell's 8 corners a receiver sees, and how interpolations weigh them by it, as kernels on any scalar.
//
// Light leaks where a corner behind a wall lends its coefficients to this side. So each vertex knows how far geometry
// is in every direction, and a corner that is farther from the receiver than geometry counts for less [1]. Not the
// distance d is kept but the nearness
//
//   q = 1 / (|x| + |y| + |z|) = 1 / (d (|w_x| + |w_y| + |w_z|)),     (x, y, z) = d w from the vertex to what is met
//
// on an octahedral map, because of a plane n . x = D it is n . p / D at the place p of the octahedron: linear on each
// of its faces, where the distance has a pole. The map is its values at nodes, which lie on all edges of the octahedron
// too, linear on triangles between: it meets a plane exactly, whatever the angle. Beside it, at each node, stands a
// quarter of the mean square of what is left of q about it; the whole leaks five times as much, and a sixteenth fails
// where all corners are half hidden. (Of moments of the distance, mean and mean square, the variance is mostly the
// slope of walls seen at an angle.) What is never met has q = 0. Towards the receiver r, with q_r its own nearness, the
// corner's share is
//
//   1 where q <= q_r, else (v / (v + (q - q_r)^2))^6
//
// Chebyshev's bound on the share of the directions thereabouts that reach as far, by the variance v, to the sixth
// power: it bounds more than there is. The receiver stands a fifth of the cell's shortest side off its surface, along
// the normal.
//
// By how many times the leak falls, the root mean square of E in the dark one of two rooms, against trilinear weights:
// a wall of 2 cm at three places in cells of 40 cm, the scene of tests/grid/rooms.hpp. (b): how far the receiver stands
// off, of the shortest side, what did best.
//
//                                        bytes    third power       sixth power
//   mean of d, d^2, 8x8 texels (b .3) [1]  512    3.5   5.7   3.4   3.9    12   4.3
//   mean of d, d^2, 16x16 texels (b .2)   2048     18   160    34    38  1100   370
//   d and d^2 in 3 bands (b .3)             72    5.8    12   1.9   7.7    21   2.2
//   d and d^2 in 6 bands (b .2)            288    3.4   3.1   3.0   3.9   3.7   3.5
//   1/d and its square, 4 bands (b .2)     128    4.8   5.5   6.4   6.5   6.4    25
//   this one, 2 rings                      216                       10    14  1100
//   3 rings                                408                       24    23   690
//   4 rings (the usual one)                664                      800    73 70000
//
// The error of E in the lit room falls too, to a third, for its furniture hides corners as well. Weights by the angle
// between normal and corner alone (wrap shading [1]) 2.2, 2.6, 1.5; on top of a map they change the leak by less than a
// tenth and are left out: with them the interpolant is another where all is visible.
//
// A weight is not just multiplied and normalised, for Hermite's weights of values have both signs, and those of
// derivatives no sum. A corner's value v_c is taken for s_c v_c + (1 - s_c) V, its derivatives for s_c times their own,
// where s_c is the share and V = sum l_c s_c v_c / sum l_c s_c what of the corners is seen, by the trilinear weights
// l_c. The weights are then
//
//   w_c s_c + (sum w - sum w s) l_c s_c / sum l s      and, of derivatives, w_c s_c
//
// which is the usual normalisation for trilinear weights, keeps a sum of 1 for all, and leaves every weight as it is,
// to the bit, where all shares are 1. To l_c 2^-16 is added, so that V is there even at a corner that is not seen. No
// share is less than 1e-6, but those of corners that lie inside geometry, 0: of corners all hidden the least hidden
// ones count. Where all 8 lie inside geometry, all weights are plain.
//
// [1] Majercik et al., Dynamic diffuse global illumination with ray-traced irradiance fields, JCGT 8(2), 2019.
#pragma once

#include <cstddef>

#include "../scalar/scalar.hpp"
#include "interpolation_weights.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Where to read a vertex's map on the way to a receiver: `nearness` is the receiver's; column and row are counted in
/// nodes from the middle of the map, -rings to rings.
template <class T>
struct MapPlace {
  T nearness, column, row;
};

/// The place for a vector from vertex to receiver, any but beyond 1e30; with (0, 0, 0) the receiver is seen. The map
/// has so many rings of nodes about its middle.
template <class T>
ZONAL_INLINE constexpr MapPlace<T> map_place(const T (&to_receiver)[3], const T& rings) {
  const T length = abs(to_receiver[0]) + abs(to_receiver[1]) + abs(to_receiver[2]);
  const T nearness = T(1) / maximum(length, T(1e-30L));
  const T u = to_receiver[0] * nearness, v = to_receiver[1] * nearness;
  const auto is_below = to_receiver[2] < T(0);
  const T folded_u = T(1) - abs(v), folded_v = T(1) - abs(u);
  const T x = select(is_below, select(u < T(0), -folded_u, folded_u), u);
  const T y = select(is_below, select(v < T(0), -folded_v, folded_v), v);
  return {nearness, rings * x, rings * y};
}

/// The vector from a corner's vertex to a receiver at t in the cell. `corner`: 0 or 1 on each axis; `offset`: by how
/// much the vertex was moved; normal: unit, or 0 where there is no surface.
template <class T>
ZONAL_INLINE constexpr void from_corner(const T (&t)[3], const T (&cell_size)[3], const T (&corner)[3],
                                        const T (&offset)[3], const T (&normal)[3], T (&to_receiver)[3]) {
  const T bias = T(0.2L) * minimum(minimum(cell_size[0], cell_size[1]), cell_size[2]);
  for (int a = 0; a < 3; ++a) to_receiver[a] = (t[a] - corner[a]) * cell_size[a] + (bias * normal[a] - offset[a]);
}

/// What the four nodes about a place give there, towards the middle first, then the next column, the next row, and
/// both, at x and y from 0 to 1 between them: linear on the two triangles whose common side lies across the way to the
/// middle.
template <class T>
struct NodeWeights {
  T weight[4];
};
template <class T>
ZONAL_INLINE constexpr NodeWeights<T> node_weights(const T& x, const T& y) {
  const T beyond = x + y - T(1), far = maximum(beyond, T(0)), near = maximum(-beyond, T(0));
  return {{near, x - far, y - far, far}};
}

/// The share of a corner, 1e-6 to 1, from the nearness at these nodes and its variance, > 0.
template <class T>
ZONAL_INLINE constexpr T seen_share(const T& nearness, const T (&mean)[4], const T (&variance)[4], const T& x,
                                    const T& y) {
  const NodeWeights<T> nodes = node_weights(x, y);
  const auto between = [&](const T(&of)[4]) ZONAL_INLINE {
    return nodes.weight[0] * of[0] + nodes.weight[1] * of[1] + (nodes.weight[2] * of[2] + nodes.weight[3] * of[3]);
  };
  const T excess = maximum(between(mean) - nearness, T(0)), spread = between(variance);
  const T bound = spread / (spread + excess * excess), cube = bound * bound * bound;
  return maximum(cube * cube, T(1e-6L));
}

/// The weights of corners of which so much is seen, 0 to 1 each, from those of an interpolation and what the axes give
/// it.
template <Interpolation method, class T>
ZONAL_INLINE constexpr CellWeights<method, T> visible_weights(const CellWeights<method, T>& weights,
                                                              const AxisWeights<T> (&axis)[3], const T (&seen)[8]) {
  T linear[8]{}, sum = T(0), kept = T(0), visible = T(0);
  for (int c = 0; c < 8; ++c) {
    const T share = axis[0].linear[c & 1] * axis[1].linear[c >> 1 & 1] * axis[2].linear[c >> 2];
    linear[c] = (share + T(1.52587890625e-5L)) * seen[c];
    sum = sum + weights.corner[c][0];
    kept = kept + weights.corner[c][0] * seen[c];
    visible = visible + linear[c];
  }
  const auto is_buried = visible <= T(0);
  const T rest = (sum - kept) / maximum(visible, T(1e-30L));
  CellWeights<method, T> result{};
  for (int c = 0; c < 8; ++c) {
    for (std::size_t block = 0; block < std::size_t(blocks_read(method)); ++block) {
      const T& plain = weights.corner[c][block];
      const T weighed = block == 0 ? plain * seen[c] + rest * linear[c] : plain * seen[c];
      result.corner[c][block] = select(is_buried, plain, weighed);
    }
  }
  return result;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
