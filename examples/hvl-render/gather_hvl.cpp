#include "gather_hvl.hpp"

#include <numeric>

#include <zonal/basis/bands.hpp>
#include <zonal/gather/hvl.hpp>

#include "scene.hpp"

namespace hvl_render {
namespace {

constexpr int most_bands = 10;
constexpr int most_emission_bands = 3;

template <int N, int NE, zonal::Horizon H>
class HvlGatherer final : public Gatherer {
 public:
  explicit HvlGatherer(const std::vector<zonal::VirtualLight>& lights) : cache_(lights) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing,
                              const zonal::MaterialTable& material) const override {
    // As in the HVL paper's figures, nothing stands between a virtual light and the receiver. A ray to each
    // light's centre would go here, once the library can leave out lights.
    return zonal::gather<N, NE, H>(cache_, zonal::Receiver{hit.position, hit.normal, outgoing, &material});
  }

 private:
  zonal::HvlCache<NE> cache_;
};

std::vector<int> one_to(int last) {
  std::vector<int> numbers(static_cast<std::size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

template <int N, int NE>
std::unique_ptr<Gatherer> make_gatherer(const std::vector<zonal::VirtualLight>& lights, HorizonRule horizon) {
  switch (horizon) {
    case HorizonRule::none:
      return std::make_unique<HvlGatherer<N, NE, zonal::Horizon::none>>(lights);
    case HorizonRule::exact:
      return std::make_unique<HvlGatherer<N, NE, zonal::Horizon::exact>>(lights);
    case HorizonRule::smoothstep:
      break;
  }
  return std::make_unique<HvlGatherer<N, NE, zonal::Horizon::smoothstep>>(lights);
}

}  // namespace

std::unique_ptr<Gatherer> make_gatherer(const std::vector<zonal::VirtualLight>& lights,
                                        const Options& options) {
  std::unique_ptr<Gatherer> gatherer;
  zonal::dispatch_bands<1, most_bands>(options.bands, [&](auto bands) {
    zonal::dispatch_bands<1, most_emission_bands>(options.emission_bands, [&](auto emission) {
      constexpr int N = bands;
      constexpr int NE = emission;
      gatherer = make_gatherer<N, NE>(lights, options.horizon);
    });
  });
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

std::vector<int> gather_bands() {
  return one_to(most_bands);
}
std::string gather_bands_text() {
  return "1..." + std::to_string(most_bands);
}
std::vector<int> emission_bands() {
  return one_to(most_emission_bands);
}
std::string emission_bands_text() {
  return "1..." + std::to_string(most_emission_bands);
}

}  // namespace hvl_render
