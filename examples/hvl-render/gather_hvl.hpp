#pragma once

#include <memory>
#include <vector>

#include <zonal/gather/virtual_light.hpp>
#include <zonal/material/material_table.hpp>

#include "options.hpp"
#include "shared/ray_caster.hpp"

namespace example::hvl_render {

/// The sum over all virtual lights, its numbers of bands fixed when it was made. Safe to use from many
/// threads.
class Gatherer {
 public:
  Gatherer() = default;
  virtual ~Gatherer() = default;
  Gatherer(const Gatherer&) = delete;
  Gatherer& operator=(const Gatherer&) = delete;

  /// Indirect radiance that leaves `hit` towards the unit direction `outgoing`.
  virtual glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing,
                                      const zonal::MaterialTable& material) const = 0;
};

/// Throws InputError for numbers of bands that are not compiled in.
std::unique_ptr<Gatherer> make_gatherer(const std::vector<zonal::VirtualLight>& lights, const Options& options);

/// The numbers of bands that are compiled in: each costs compile time.
std::vector<int> gather_bands();
std::vector<int> emission_bands();

}  // namespace example::hvl_render
