#pragma once

#include <cstddef>
#include <memory>

#include <glm/glm.hpp>

#include "options.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"
#include "virtual_lights.hpp"

namespace example::hvl_render {

/// The sum over all virtual lights, by the method it was made for. Safe to use from many threads.
class Gatherer {
 public:
  Gatherer() = default;
  virtual ~Gatherer() = default;
  Gatherer(const Gatherer&) = delete;
  Gatherer& operator=(const Gatherer&) = delete;

  /// Indirect radiance that leaves `hit` towards the unit direction `outgoing`. `sample` numbers the hit within the
  /// image and seeds the random numbers of methods that need some.
  virtual glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t sample) const = 0;
};

/// What a method gathers, and with what.
struct GatherInput {
  const Scene& scene;
  const RayCaster& caster;
  const MaterialTables& materials;
  const VirtualLightMap& map;
  const Options& options;
};

/// The options' method; not for paths. What `input` refers to must outlive it. Throws InputError for numbers of bands
/// that are not compiled in.
std::unique_ptr<Gatherer> make_gatherer(const GatherInput& input);

}  // namespace example::hvl_render
