// Gradients of a filled grid, limited so that Hermite interpolation does not overshoot.
//
// Between two vertices a cubic leaves the range of its ends where a slope there is steeper than three times the chord,
// or leads the other way [1]. With h the cell's length, D the steps of a coefficient to the two neighbours along an
// axis, and c the coefficient of degree 0 at the vertex, the derivative is brought into
//
//   from min(0, 3/2 D / h) - 4 o c / h to max(0, 3/2 D / h) + 4 o c / h, of both steps; of one at a face of the box.
//
// Along the edges of cells every coefficient then stays between the two ends but for o times the greater c; inside,
// where the cubics of three axes add up, within the range of the cell's 8 corners but for 3 o c and 0.074 of its width
// (0.625, were three chords allowed; as much as it likes, as it is).
//
// What it costs: o = 0 takes the derivatives at extremes away, so that the error there falls as h^2 and not as h^4;
// with an o of some hundredths nothing changes as soon as cells are small against what is in them (docs/rooms/grid.md).
// That coefficients stay in range does not make radiance that is not negative: what a few bands ring below zero, at the
// vertices too, is for a window (transform/window.hpp).
//
// [1] Fritsch and Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17(2), 1980.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "../scalar/for_each.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Limits every derivative, by x, y and z, of every coefficient and channel; `overshoot` >= 0 is the o above. The
/// values stay. for_each as in add_lights.hpp.
template <int N, class ForEach = SerialForEach>
void limit_gradients(CoefficientGrid<N>& grid, float overshoot, ForEach&& for_each = {}) {
  using Grid = CoefficientGrid<N>;
  constexpr float chords = 1.5F;
  const glm::ivec3 size = grid.resolution();
  const std::size_t strides[3] = {1, std::size_t(size.x), std::size_t(size.x) * std::size_t(size.y)};
  for_each(int(grid.vertex_count()), [&](int index) {
    float* const vertex = grid.data() + std::size_t(index) * Grid::vertex_size;
    const std::size_t place[3] = {std::size_t(index) % strides[1],
                                  std::size_t(index) / strides[1] % std::size_t(size.y),
                                  std::size_t(index) / strides[2]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t step = strides[axis] * Grid::vertex_size;
      const bool has_below = place[axis] > 0, has_above = place[axis] + 1 < std::size_t(size[int(axis)]);
      const float* const below = has_below ? vertex - step : nullptr;
      const float* const above = has_above ? vertex + step : nullptr;
      const float rate = chords / grid.spacing()[int(axis)];
      float* const slopes = vertex + (axis + 1) * Grid::block_size;
      for (int i = 0; i < Grid::block_size; ++i) {
        // The slopes that both steps allow: from `least` to `most`, which both are 0 where the steps differ in sign.
        float least = -std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::infinity();
        const auto allow = [&](float chord) {
          least = (std::max)(least, (std::min)(0.0F, rate * chord));
          most = (std::min)(most, (std::max)(0.0F, rate * chord));
        };
        if (below) allow(vertex[i] - below[i]);
        if (above) allow(above[i] - vertex[i]);
        const float more = overshoot * 4 / grid.spacing()[int(axis)] * std::abs(vertex[i % 3]);
        slopes[i] = (std::min)((std::max)(slopes[i], least - more), most + more);
      }
    }
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
