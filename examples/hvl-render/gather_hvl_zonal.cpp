#include <zonal/gather/hvl_zonal.hpp>

#include "gather_hvl.hpp"

namespace example::hvl_render {
namespace {

template <int N>
class ZonalGatherer final : public Gatherer {
 public:
  explicit ZonalGatherer(const GatherInput& input) : input_(input), cache_(lit(input.map)) {}

  glm::vec3 indirect_radiance(const Hit& hit, const glm::vec3& outgoing, std::size_t) const override {
    return zonal::gather_hvl_zonal<N>(cache_, receiver(hit, outgoing), input_.materials.zonal[hit.material],
                                      visibility(input_, hit));
  }

 private:
  GatherInput input_;
  zonal::LightCache cache_;
};

}  // namespace

/// Null for numbers of bands that are not compiled in.
std::unique_ptr<Gatherer> make_hvl_zonal(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer;
  zonal::dispatch_bands<1, compiled_zonal_bands.back()>(input.options.bands, [&](auto n) {
    constexpr int N = n;
    if constexpr (contains(compiled_zonal_bands, N)) gatherer = std::make_unique<ZonalGatherer<N>>(input);
  });
  return gatherer;
}

}  // namespace example::hvl_render
