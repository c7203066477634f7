#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <zonal/basis/bands.hpp>
#include <zonal/gather/hvl.hpp>

#include "gather_hvl.hpp"

namespace example::hvl_render {

/// What --bands and --emission-bands offer. Each pair is a kernel of its own, a second of compile time and
/// more, and that for each horizon, which has a source file of its own.
inline constexpr std::array compiled_bands{1, 2, 3, 4, 5, 7, 9};
inline constexpr std::array compiled_emission_bands{1, 3, 5};

template <std::size_t Size>
constexpr bool contains(const std::array<int, Size>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

template <int N, int NE, zonal::Horizon H>
class HvlGatherer final : public Gatherer {
 public:
  explicit HvlGatherer(const std::vector<zonal::VirtualLight>& lights) : cache_(lights) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing,
                              const zonal::MaterialTable& material) const override {
    // As in the HVL paper's figures, nothing stands between a virtual light and the receiver. A ray to each
    // light's centre would go here, once the library can leave out lights.
    return zonal::gather<N, NE, H>(cache_, zonal::Receiver{hit.position, hit.normal, outgoing}, material);
  }

 private:
  zonal::HvlCache<NE> cache_;
};

/// Null for numbers of bands that are not compiled in.
template <zonal::Horizon H>
std::unique_ptr<Gatherer> make_gatherer_with(const std::vector<zonal::VirtualLight>& lights, int bands,
                                             int emission_bands) {
  std::unique_ptr<Gatherer> gatherer;
  zonal::dispatch_bands<1, compiled_bands.back()>(bands, [&](auto n) {
    zonal::dispatch_bands<1, compiled_emission_bands.back()>(emission_bands, [&](auto ne) {
      constexpr int N = n;
      constexpr int NE = ne;
      if constexpr (contains(compiled_bands, N) && contains(compiled_emission_bands, NE)) {
        gatherer = std::make_unique<HvlGatherer<N, NE, H>>(lights);
      }
    });
  });
  return gatherer;
}

}  // namespace example::hvl_render
