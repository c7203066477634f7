#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include <zonal/basis/bands.hpp>
#include <zonal/gather/hvl.hpp>

#include "gatherer.hpp"

namespace example::hvl_render {

/// What --bands and --emission-bands offer. Each pair is a kernel of its own, a second of compile time and
/// more, and that for each horizon, which has a source file of its own.
inline constexpr std::array compiled_bands{1, 2, 3, 4, 5, 7, 9};
inline constexpr std::array compiled_emission_bands{1, 3, 5};
/// What --bands offers to the zonal gather, where a band costs little.
inline constexpr std::array compiled_zonal_bands{3, 5, 7, 9, 15, 21};

template <std::size_t Size>
constexpr bool contains(const std::array<int, Size>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

inline zonal::Receiver receiver(const Hit& hit, const glm::vec3& outgoing) {
  return {hit.position, hit.normal, outgoing};
}

/// A ray to the light's centre, just off its surface; or none, and all is visible.
inline zonal::Visibility visibility(const GatherInput& input, const Hit& hit) {
  if (!input.options.centre_visibility) return {};
  struct Ray {
    const RayCaster& caster;
    const Hit& from;
  };
  const Ray ray{input.caster, hit};
  return [ray](const glm::vec3& position, const glm::vec3& normal) {
    return ray.caster.visible(ray.from, Hit{position, normal, normal, 0.0f, 0});
  };
}

template <int N, int NE, zonal::Horizon H>
class HvlGatherer final : public Gatherer {
 public:
  explicit HvlGatherer(const GatherInput& input) : input_(input), cache_(lit(input.map)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t) const override {
    return zonal::gather<N, NE, H>(cache_, receiver(hit, outgoing), input_.materials.receiving[hit.material],
                                   visibility(input_, hit));
  }

 private:
  GatherInput input_;
  zonal::HvlCache<NE> cache_;
};

/// Null for numbers of bands that are not compiled in.
template <zonal::Horizon H>
std::unique_ptr<Gatherer> make_hvl(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer;
  zonal::dispatch_bands<1, compiled_bands.back()>(input.options.bands, [&](auto n) {
    zonal::dispatch_bands<1, compiled_emission_bands.back()>(input.options.emission_bands, [&](auto ne) {
      constexpr int N = n;
      constexpr int NE = ne;
      if constexpr (contains(compiled_bands, N) && contains(compiled_emission_bands, NE)) {
        gatherer = std::make_unique<HvlGatherer<N, NE, H>>(input);
      }
    });
  });
  return gatherer;
}

}  // namespace example::hvl_render
