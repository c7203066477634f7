// Filling a grid from lights: every vertex sees every light. No visibility.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "../light/polygon.hpp"
#include "../light/sphere.hpp"
#include "coefficient_grid.hpp"
#include "light_sums.hpp"

namespace zonal {

namespace detail {

using VertexLanes = Packet<float, kNativeLanes>;
inline constexpr int lights_at_once = 4;
using LightLanes = Packet<float, lights_at_once * kNativeLanes>;

// The positions of up to kNativeLanes vertices from `first` on; lanes beyond the last vertex repeat it.
template <int N>
struct VertexPacket {
  VertexLanes position[3];
  std::size_t first, count;

  VertexPacket(const CoefficientGrid<N>& grid, std::size_t packet) : first(packet * kNativeLanes) {
    count = std::min<std::size_t>(kNativeLanes, grid.vertex_count() - first);
    const auto width = static_cast<std::size_t>(grid.resolution().x),
               height = static_cast<std::size_t>(grid.resolution().y);
    float lanes[3][kNativeLanes];
    for (std::size_t lane = 0; lane < kNativeLanes; ++lane) {
      const std::size_t vertex = first + std::min(lane, count - 1);
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

// Four lights as one whose fields have a block of lanes for each.
inline SphereLight<LightLanes> in_lanes(const std::array<SphereLight<float>, lights_at_once>& lights) {
  const auto field = [&](auto get) {
    float values[lights_at_once];
    for (std::size_t i = 0; i < lights_at_once; ++i) values[i] = get(lights[i]);
    return LightLanes::blocks<lights_at_once>(values);
  };
  return {
      {field([](const auto& light) { return light.center.x; }), field([](const auto& light) { return light.center.y; }),
       field([](const auto& light) { return light.center.z; })},
      field([](const auto& light) { return light.radius; })};
}

}  // namespace detail

/// Adds sphere lights to the grid: value and gradient at every vertex. for_each(count, body) calls body(0), ...,
/// body(count - 1), in any order, on as many threads as it likes.
template <int N, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<SphereLight<float>>>& lights,
                ForEach&& for_each) {
  using detail::lights_at_once, detail::LightLanes, detail::VertexLanes;
  if (lights.empty()) return;
  const auto packets = static_cast<int>((grid.vertex_count() + kNativeLanes - 1) / kNativeLanes);
  for_each(packets, [&](int packet) {
    const detail::VertexPacket<N> vertices(grid, static_cast<std::size_t>(packet));
    LightLanes position[3];
    for (int i = 0; i < 3; ++i) position[i] = vertices.position[i].template repeated<lights_at_once>();

    LightSums<N, VertexLanes, LightLanes> sums;
    for (std::size_t first = 0; first < lights.size(); first += lights_at_once) {
      std::array<SphereLight<float>, lights_at_once> group;
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
      sums.add(detail::in_lanes(group), colours, position[0], position[1], position[2]);
    }
    sums.finish([&](auto l, auto m, int c, const VertexLanes& value, const VertexLanes& x, const VertexLanes& y,
                    const VertexLanes& z) { vertices.add(grid, 3 * sh_index(l, m) + c, value, x, y, z); });
  });
}

namespace detail {
// Adds `count` lights, one after the other: project(i, vertices, sink) hands out value and gradient of light i as
// project_with_gradient does.
template <int N, class Lights, class ForEach, class Project>
void add_one_by_one(CoefficientGrid<N>& grid, const Lights& lights, ForEach&& for_each, const Project& project) {
  const auto packets = static_cast<int>((grid.vertex_count() + kNativeLanes - 1) / kNativeLanes);
  for_each(packets, [&](int packet) {
    const VertexPacket<N> vertices(grid, static_cast<std::size_t>(packet));
    ShGradient<N, std::array<VertexLanes, 3>> sums;
    for (auto* sh : {&sums.value, &sums.gradient[0], &sums.gradient[1], &sums.gradient[2]}) {
      for (auto& rgb : *sh) rgb.fill(VertexLanes(0));
    }
    for (const auto& light : lights) {
      const VertexLanes colour[3] = {VertexLanes(light.colour[0]), VertexLanes(light.colour[1]),
                                     VertexLanes(light.colour[2])};
      project(light.light, vertices.position,
              [&](auto l, auto m, const VertexLanes& value, const VertexLanes& x, const VertexLanes& y,
                  const VertexLanes& z) ZONAL_INLINE {
                constexpr int i = sh_index(l, m);
                for (std::size_t c = 0; c < 3; ++c) {
                  add_product(sums.value.values[i][c], value, colour[c]);
                  add_product(sums.gradient[0].values[i][c], x, colour[c]);
                  add_product(sums.gradient[1].values[i][c], y, colour[c]);
                  add_product(sums.gradient[2].values[i][c], z, colour[c]);
                }
              });
    }
    for (int i = 0; i < N * N; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        vertices.add(grid, 3 * i + static_cast<int>(c), sums.value[i][c], sums.gradient[0][i][c],
                     sums.gradient[1][i][c], sums.gradient[2][i][c]);
      }
    }
  });
}

inline float least_lane(const VertexLanes& x) {
  float lanes[kNativeLanes];
  x.store(lanes);
  return *std::min_element(lanes, lanes + kNativeLanes);
}
}  // namespace detail

/// Adds lights of any other kind that `project_with_gradient<N>(light, x, y, z, sink)` takes (light/radial.hpp).
template <int N, class Light, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<Light>>& lights, ForEach&& for_each) {
  detail::add_one_by_one(grid, lights, for_each, [](const Light& light, const auto& x, auto&& sink) ZONAL_INLINE {
    project_with_gradient<N>(light, x[0], x[1], x[2], sink);
  });
}

/// Adds polygon lights within `tolerance` of each light's largest coefficient: as many nodes per edge as the vertices
/// of a packet need, those that see the light largest.
template <int N, int V, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<PolygonLight<V, float>>>& lights,
                double tolerance, ForEach&& for_each) {
  const EdgeRules rules(N, tolerance);
  detail::add_one_by_one(
      grid, lights, for_each, [&](const PolygonLight<V, float>& light, const auto& x, auto&& sink) ZONAL_INLINE {
        const float arc = acos(detail::least_lane(least_arc_cosine(light, x[0], x[1], x[2])));
        finish<N>(polygon_sums<N>(light, rules.for_arc(static_cast<double>(arc)), x[0], x[1], x[2]), sink);
      });
}

}  // namespace zonal
