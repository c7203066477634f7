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

template <class Grid>
int vertex_packet_count(const Grid& grid) {
  return static_cast<int>((grid.vertex_count() + kNativeLanes - 1) / kNativeLanes);
}

// The positions of up to kNativeLanes vertices from `first` on; lanes beyond the last vertex repeat it.
template <class Grid>
struct VertexPacket {
  VertexLanes position[3];
  std::size_t first, count;

  VertexPacket(const Grid& grid, std::size_t packet) : first(packet * kNativeLanes) {
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

  // Adds to float number `coefficient` of the value, and of the derivatives by x, y and z.
  template <class... Derivatives>
  ZONAL_INLINE void add(Grid& grid, int coefficient, const VertexLanes& value,
                        const Derivatives&... derivatives) const {
    static_assert(1 + sizeof...(Derivatives) == Grid::block_count, "as many as the grid has blocks");
    const VertexLanes* const blocks[] = {&value, &derivatives...};
    for (std::size_t block = 0; block < Grid::block_count; ++block) {
      float lanes[kNativeLanes];
      blocks[block]->store(lanes);
      float* target = grid.data() + first * Grid::vertex_size + block * Grid::block_size + std::size_t(coefficient);
      for (std::size_t lane = 0; lane < count; ++lane) target[lane * Grid::vertex_size] += lanes[lane];
    }
  }
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
