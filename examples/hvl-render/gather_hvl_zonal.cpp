#include <zonal/gather/hvl_zonal.hpp>

#include "gather_hvl.hpp"

namespace example::hvl_render {

std::unique_ptr<Gatherer> make_hvl_zonal(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer;
  zonal::dispatch_bands<1, compiled_zonal_bands.back()>(input.options.bands, [&](auto n) {
    constexpr int N = n;
    if constexpr (contains(compiled_zonal_bands, N)) {
      const auto gather = [&tables = input.materials](const auto& cache, const zonal::Receiver& receiver,
                                                      const Hit& hit, std::size_t, const zonal::Visibility& visible) {
        return zonal::gather_hvl_zonal<N>(cache, receiver, tables.zonal[hit.material], visible, hit.colour);
      };
      gatherer = make_cached(input, zonal::LightCache(lit(input.map)), gather);
    }
  });
  return gatherer;
}

}  // namespace example::hvl_render
