// Filling a grid from lights: every vertex sees every light. No visibility. Polygons: add_polygons.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "../light/point.hpp"
#include "../light/radial.hpp"
#include "coefficient_grid.hpp"
#include "light_sums.hpp"
#include "vertex_packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

inline constexpr int lights_at_once = 4;
using LightLanes = Packet<float, lights_at_once * kNativeLanes>;

// The light whose numbers are packets.
template <class Light, class Lanes>
struct WideLightOf;
template <template <class> class Light, class Lanes>
struct WideLightOf<Light<float>, Lanes> {
  using Type = Light<Lanes>;
};
template <template <int, class> class Light, int N, class Lanes>
struct WideLightOf<Light<N, float>, Lanes> {
  using Type = Light<N, Lanes>;
};

// Four lights as one. A light is its numbers, one after the other; each has a block of lanes for each of the four.
template <class Light>
typename WideLightOf<Light, LightLanes>::Type side_by_side(const std::array<Light, lights_at_once>& lights) {
  using Wide = typename WideLightOf<Light, LightLanes>::Type;
  constexpr std::size_t size = sizeof(Light) / sizeof(float);
  static_assert(std::is_trivially_copyable_v<Light> && std::is_trivially_copyable_v<Wide>);
  static_assert(sizeof(Wide) == size * sizeof(LightLanes), "a light holds numbers of its scalar, and nothing else");
  float numbers[lights_at_once][size];
  std::memcpy(numbers, lights.data(), sizeof numbers);
  LightLanes lanes[size];
  for (std::size_t n = 0; n < size; ++n) {
    float block[lights_at_once];
    for (int i = 0; i < lights_at_once; ++i) block[i] = numbers[i][n];
    lanes[n] = LightLanes::blocks<lights_at_once>(block);
  }
  Wide wide;
  std::memcpy(&wide, lanes, sizeof wide);
  return wide;
}

}  // namespace detail

/// Adds lights that are symmetric about the direction to them, modulated or not (light/radial.hpp): value and gradient
/// at every vertex. for_each(count, body) calls body(0), ..., body(count - 1), in any order, on as many threads as it
/// likes.
template <int N, class Light, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<Light>>& lights, ForEach&& for_each) {
  using detail::lights_at_once, detail::LightLanes, detail::VertexLanes;
  if (lights.empty()) return;
  for_each(detail::vertex_packet_count(grid), [&](int packet) {
    const detail::VertexPacket<N> vertices(grid, static_cast<std::size_t>(packet));
    LightLanes position[3];
    for (int i = 0; i < 3; ++i) position[i] = vertices.position[i].template repeated<lights_at_once>();

    LightSums<N, VertexLanes, LightLanes, detail::ModulationOf<Light, float>::exists> sums;
    for (std::size_t first = 0; first < lights.size(); first += lights_at_once) {
      std::array<Light, lights_at_once> group;
      float colour[3][lights_at_once];
      for (std::size_t i = 0; i < lights_at_once; ++i) {  // what is missing in the last group is black
        const bool exists = first + i < lights.size();
        const auto& light = lights[exists ? first + i : first];
        group[i] = light.light;
        for (int c = 0; c < 3; ++c) colour[c][i] = exists ? light.colour[c] : 0.0F;
      }
      const LightLanes colours[3] = {LightLanes::blocks<lights_at_once>(colour[0]),
                                     LightLanes::blocks<lights_at_once>(colour[1]),
                                     LightLanes::blocks<lights_at_once>(colour[2])};
      sums.add(detail::side_by_side(group), colours, position[0], position[1], position[2]);
    }
    sums.finish([&](auto l, auto m, int c, const VertexLanes& value, const VertexLanes& x, const VertexLanes& y,
                    const VertexLanes& z) { vertices.add(grid, 3 * sh_index(l, m) + c, value, x, y, z); });
  });
}

/// Adds directional lights: the same value everywhere, and no gradient.
template <int N, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<DirectionalLight<float>>>& lights,
                ForEach&& for_each) {
  Sh<N, glm::vec3> sum{};
  for (const auto& [light, colour] : lights) {
    const Sh<N, float> sh = evaluate<N>(light.direction);
    for (int i = 0; i < N * N; ++i) sum[i] += sh[i] * colour;
  }
  for_each(static_cast<int>(grid.vertex_count()), [&](int vertex) {
    float* value = grid.data() + static_cast<std::size_t>(vertex) * CoefficientGrid<N>::vertex_size;
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) value[3 * i + c] += sum[i][c];
    }
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
