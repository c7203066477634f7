#include "gather_hvl.hpp"

#include "gather_bands.hpp"
#include "shared/input_error.hpp"

namespace example::hvl_render {

extern template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::smoothstep>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);
extern template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::exact>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);

std::unique_ptr<Gatherer> make_gatherer(const std::vector<zonal::VirtualLight>& lights, const Options& options) {
  const auto make = options.horizon == HorizonRule::exact ? make_gatherer_with<zonal::Horizon::exact>
                                                          : make_gatherer_with<zonal::Horizon::smoothstep>;
  std::unique_ptr<Gatherer> gatherer = make(lights, options.bands, options.emission_bands);
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

std::vector<int> gather_bands() { return {compiled_bands.begin(), compiled_bands.end()}; }

std::vector<int> emission_bands() { return {compiled_emission_bands.begin(), compiled_emission_bands.end()}; }

}  // namespace example::hvl_render
