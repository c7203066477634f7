#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include <zonal/grid/add_lights.hpp>

#include "lights.hpp"

namespace example::grid_render {

using Lanes = zonal::Packet<float, zonal::kNativeLanes>;

/// As many lights as a packet has lanes, as one light whose numbers are packets.
template <class Light>
struct LightPacket {
  using WideLight = typename zonal::detail::WideLightOf<Light, Lanes>::Type;

  /// What is missing in the last packet is black.
  LightPacket(const Lights<Light>& lights, std::size_t first) {
    constexpr std::size_t light_size = sizeof(Light) / sizeof(float), size = light_size + 3;
    static_assert(std::is_trivially_copyable_v<Light> && std::is_trivially_copyable_v<WideLight>);
    static_assert(sizeof(WideLight) == light_size * sizeof(Lanes), "a light holds numbers of its scalar only");
    float numbers[size][zonal::kNativeLanes];
    for (std::size_t lane = 0; lane < zonal::kNativeLanes; ++lane) {
      const bool exists = first + lane < lights.size();
      const auto& [light_of_lane, rgb] = lights[exists ? first + lane : first];
      float of_light[light_size];
      std::memcpy(of_light, &light_of_lane, sizeof of_light);
      for (std::size_t n = 0; n < light_size; ++n) numbers[n][lane] = of_light[n];
      for (int c = 0; c < 3; ++c) numbers[light_size + static_cast<std::size_t>(c)][lane] = exists ? rgb[c] : 0.0f;
    }
    std::memcpy(&light, numbers, sizeof light);
    for (std::size_t c = 0; c < 3; ++c) colour[c] = Lanes::load(numbers[light_size + c]);
  }

  WideLight light;
  std::array<Lanes, 3> colour;
};

template <class Light>
std::vector<LightPacket<Light>> packets_of(const Lights<Light>& lights) {
  std::vector<LightPacket<Light>> packets;
  for (std::size_t first = 0; first < lights.size(); first += zonal::kNativeLanes) packets.emplace_back(lights, first);
  return packets;
}

}  // namespace example::grid_render
