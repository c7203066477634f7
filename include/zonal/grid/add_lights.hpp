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
#include "../scalar/long_sum.hpp"
#include "coefficient_grid.hpp"
#include "gradient_limit.hpp"
#include "light_sums.hpp"
#include "vertex_packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// The light whose numbers are packets.
template <class Light, class Lanes>
struct WideLightOf {
  using Type = void;
};
template <template <class> class Light, class Lanes>
struct WideLightOf<Light<float>, Lanes> {
  using Type = Light<Lanes>;
};
template <template <int, class> class Light, int N, class Lanes>
struct WideLightOf<Light<N, float>, Lanes> {
  using Type = Light<N, Lanes>;
};

// Whether a light is floats, one after the other, and nothing else; and the wide one as many packets.
template <class Light, class Lanes>
constexpr bool is_numbers() {
  using Wide = typename WideLightOf<Light, Lanes>::Type;
  if constexpr (std::is_void_v<Wide>) {
    return false;
  } else {
    return std::is_standard_layout_v<Light> && std::is_standard_layout_v<Wide> &&
           std::is_default_constructible_v<Wide> && sizeof(Wide) / sizeof(Lanes) * sizeof(float) == sizeof(Light) &&
           sizeof(Wide) % sizeof(Lanes) == 0;
  }
}

// Lights as the sums take them: four at once, each with a block of lanes, where they are numbers, else one by one.
template <class Light>
struct LightGroup {
  static constexpr bool is_wide = is_numbers<Light, Packet<float, 4 * kNativeLanes>>();
  static constexpr int size = is_wide ? 4 : 1;
  using Lanes = Packet<float, size * kNativeLanes>;

  static auto of(const std::array<const Light*, std::size_t{size}>& lights) {
    if constexpr (is_wide) {
      constexpr std::size_t count = sizeof(Light) / sizeof(float);
      constexpr auto held = static_cast<std::size_t>(size);
      float numbers[held][count];
      for (std::size_t i = 0; i < held; ++i)
        std::memcpy(numbers[i], static_cast<const void*>(lights[i]), sizeof numbers[i]);
      Lanes lanes[count];
      for (std::size_t n = 0; n < count; ++n) {
        float block[held];
        for (std::size_t i = 0; i < held; ++i) block[i] = numbers[i][n];
        lanes[n] = Lanes::template blocks<size>(block);
      }
      typename WideLightOf<Light, Lanes>::Type wide;
      std::memcpy(static_cast<void*>(&wide), lanes, sizeof wide);
      return wide;
    } else {
      return *lights[0];
    }
  }
};

}  // namespace detail

/// Adds lights that are symmetric about the direction to them, modulated or not (light/radial.hpp): value and gradient
/// at every vertex, the gradient as far as a cell can use it (gradient_limit.hpp), or the value alone. for_each(count,
/// body) calls body(0),
/// ..., body(count - 1), in any order, on as many threads as it likes.
template <int N, GridContent content, class Light, class ForEach>
void add_lights(CoefficientGrid<N, content>& grid, const std::vector<ColouredLight<Light>>& lights,
                ForEach&& for_each) {
  using Grid = CoefficientGrid<N, content>;
  using detail::VertexLanes;
  using Group = detail::LightGroup<Light>;
  using Lanes = typename Group::Lanes;
  constexpr auto at_once = static_cast<std::size_t>(Group::size);
  if (lights.empty()) return;
  const float cell = (std::max)({grid.spacing().x, grid.spacing().y, grid.spacing().z});
  std::vector<float> at_centre;
  at_centre.reserve(lights.size());
  for (const auto& light : lights) at_centre.push_back(gradient_limit(light.light, cell).at_centre);

  for_each(detail::vertex_packet_count(grid), [&](int packet) {
    const detail::VertexPacket<Grid> vertices(grid, static_cast<std::size_t>(packet));
    Lanes position[3];
    for (int i = 0; i < 3; ++i) position[i] = vertices.position[i].template repeated<Group::size>();
    GradientLimit<Lanes> limit{Lanes(cell), Lanes(1 / cell), Lanes(0)};

    LightSums<N, VertexLanes, Lanes, detail::ModulationOf<Light, Lanes>::exists, Grid::has_gradients> sums;
    LongSums<VertexLanes> totals;
    for (std::size_t first = 0; first < lights.size(); first += at_once) {
      if (first > 0 && first % (terms_in_block * at_once) == 0) totals.take(sums);
      std::array<const Light*, at_once> group;
      float colour[3][at_once], centre[at_once];
      for (std::size_t i = 0; i < at_once; ++i) {  // what is missing in the last group is black
        const bool exists = first + i < lights.size();
        const std::size_t place = exists ? first + i : first;
        group[i] = &lights[place].light;
        centre[i] = at_centre[place];
        for (int c = 0; c < 3; ++c) colour[c][i] = exists ? lights[place].colour[c] : 0.0F;
      }
      const auto blocks = [](const float(&numbers)[at_once]) { return Lanes::template blocks<Group::size>(numbers); };
      const Lanes colours[3] = {blocks(colour[0]), blocks(colour[1]), blocks(colour[2])};
      limit.at_centre = blocks(centre);
      sums.add(see_limited<N>(Group::of(group), position[0], position[1], position[2], limit), colours);
    }
    totals.finish(sums);
    sums.finish([&](int l, int m, int c, const auto&... value_and_gradient) {
      vertices.add(grid, 3 * sh_index(l, m) + c, value_and_gradient...);
    });
  });
}

/// Adds directional lights: the same value everywhere, and no gradient.
template <int N, GridContent content, class ForEach>
void add_lights(CoefficientGrid<N, content>& grid, const std::vector<ColouredLight<DirectionalLight<float>>>& lights,
                ForEach&& for_each) {
  using Grid = CoefficientGrid<N, content>;
  Sh<N, glm::dvec3> sum{};  // in double, for there may be many
  for (const auto& [light, colour] : lights) {
    const Sh<N, float> sh = evaluate<N>(light.direction);
    for (int i = 0; i < N * N; ++i) sum[i] += glm::dvec3(sh[i] * colour);
  }
  for_each(detail::vertex_packet_count(grid), [&](int packet) {
    const detail::VertexPacket<Grid> vertices(grid, static_cast<std::size_t>(packet));
    for (std::size_t vertex = vertices.first; vertex < vertices.first + vertices.count; ++vertex) {
      float* value = grid.data() + vertex * Grid::vertex_size;
      for (int i = 0; i < N * N; ++i) {
        for (int c = 0; c < 3; ++c) value[3 * i + c] += static_cast<float>(sum[i][c]);
      }
    }
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
