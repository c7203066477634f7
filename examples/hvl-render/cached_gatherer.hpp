#pragma once

#include <memory>
#include <utility>

#include <zonal/gather/receiver.hpp>

#include "gatherer.hpp"

namespace example::hvl_render {

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

/// A cache of lights and one of the library's gathers: a callable (cache, receiver, number of the material, number of
/// the sample, visibility) -> radiance.
template <class Cache, class Gather>
class CachedGatherer final : public Gatherer {
 public:
  CachedGatherer(const GatherInput& input, Cache cache, Gather gather)
      : input_(input), cache_(std::move(cache)), gather_(std::move(gather)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t sample) const override {
    const zonal::Receiver receiver{hit.position, hit.normal, outgoing, hit.tangent};
    return gather_(cache_, receiver, hit.material, sample, visibility(input_, hit));
  }

 private:
  GatherInput input_;
  Cache cache_;
  Gather gather_;
};

template <class Cache, class Gather>
std::unique_ptr<Gatherer> make_cached(const GatherInput& input, Cache cache, Gather gather) {
  return std::make_unique<CachedGatherer<Cache, Gather>>(input, std::move(cache), std::move(gather));
}

}  // namespace example::hvl_render
