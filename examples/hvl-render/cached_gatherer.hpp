#pragma once

#include <memory>
#include <utility>

#include <zonal/gather/receiver.hpp>

#include "gatherer.hpp"

namespace example::hvl_render {

/// A ray from a hit to a light's centre, just off its surface.
struct CentreRay {
  const RayCaster& caster;
  const Hit& from;

  bool operator()(const glm::vec3& position, const glm::vec3& normal) const {
    return caster.visible(from, Hit{position, normal, normal, 0.0f, 0});
  }
};

/// A cache of lights and one of the library's gathers: a callable (cache, receiver, hit, number of the sample,
/// visibility) -> radiance.
template <class Cache, class Gather>
class CachedGatherer final : public Gatherer {
 public:
  CachedGatherer(const GatherInput& input, Cache cache, Gather gather)
      : input_(input), cache_(std::move(cache)), gather_(std::move(gather)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t sample) const override {
    const zonal::Receiver receiver{hit.position, hit.normal, outgoing, hit.tangent};
    const CentreRay ray{input_.caster, hit};
    const bool is_asked = input_.options.centre_visibility;  // else all is visible
    return gather_(cache_, receiver, hit, sample, is_asked ? zonal::Visibility(ray) : zonal::Visibility());
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
