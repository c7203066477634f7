// A packet of a grid's vertices: where they are, and how results find their way into the grid.
#pragma once

#include <algorithm>
#include <cstddef>

#include "../scalar/packet.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

using VertexLanes = Packet<float, kNativeLanes>;

template <int N>
int vertex_packet_count(const CoefficientGrid<N>& grid) {
  return static_cast<int>((grid.vertex_count() + kNativeLanes - 1) / kNativeLanes);
}

// The positions of up to kNativeLanes vertices from `first` on; lanes beyond the last vertex repeat it.
template <int N>
struct VertexPacket {
  VertexLanes position[3];
  std::size_t first, count;

  VertexPacket(const CoefficientGrid<N>& grid, std::size_t packet) : first(packet * kNativeLanes) {
    count = (std::min<std::size_t>)(kNativeLanes, grid.vertex_count() - first);
    const auto width = static_cast<std::size_t>(grid.resolution().x),
               height = static_cast<std::size_t>(grid.resolution().y);
    float lanes[3][kNativeLanes];
    for (std::size_t lane = 0; lane < kNativeLanes; ++lane) {
      const std::size_t vertex = first + (std::min)(lane, count - 1);
      const glm::vec3 p = grid.position(glm::ivec3(vertex % width, vertex / width % height, vertex / width / height));
      for (int i = 0; i < 3; ++i) lanes[i][lane] = p[i];
    }
    for (int i = 0; i < 3; ++i) position[i] = VertexLanes::load(lanes[i]);
  }

  // Adds to float number `coefficient` of each of the four blocks.
  ZONAL_INLINE void add(CoefficientGrid<N>& grid, int coefficient, const VertexLanes& value, const VertexLanes& x,
                        const VertexLanes& y, const VertexLanes& z) const {
    const VertexLanes* const blocks[4] = {&value, &x, &y, &z};
    for (std::size_t block = 0; block < 4; ++block) {
      float lanes[kNativeLanes];
      blocks[block]->store(lanes);
      float* target = grid.data() + first * CoefficientGrid<N>::vertex_size + block * CoefficientGrid<N>::block_size +
                      static_cast<std::size_t>(coefficient);
      for (std::size_t lane = 0; lane < count; ++lane) target[lane * CoefficientGrid<N>::vertex_size] += lanes[lane];
    }
  }
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
