#include "gather_hvl.hpp"

#include "gather_bands.hpp"
#include "scene.hpp"

namespace hvl_render {

extern template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::none>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);
extern template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::smoothstep>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);
extern template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::exact>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);

namespace {

std::unique_ptr<Gatherer> find_gatherer(const std::vector<zonal::VirtualLight>& lights,
                                        const Options& options) {
  const int bands = options.bands;
  const int emission_bands = options.emission_bands;
  switch (options.horizon) {
    case HorizonRule::none:
      return make_gatherer_with<zonal::Horizon::none>(lights, bands, emission_bands);
    case HorizonRule::exact:
      return make_gatherer_with<zonal::Horizon::exact>(lights, bands, emission_bands);
    case HorizonRule::smoothstep:
      break;
  }
  return make_gatherer_with<zonal::Horizon::smoothstep>(lights, bands, emission_bands);
}

}  // namespace

std::unique_ptr<Gatherer> make_gatherer(const std::vector<zonal::VirtualLight>& lights,
                                        const Options& options) {
  std::unique_ptr<Gatherer> gatherer = find_gatherer(lights, options);
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

std::vector<int> gather_bands() {
  return {compiled_bands.begin(), compiled_bands.end()};
}

std::vector<int> emission_bands() {
  return {compiled_emission_bands.begin(), compiled_emission_bands.end()};
}

}  // namespace hvl_render
