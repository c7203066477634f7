#pragma once

#include <memory>

#include <zonal/basis/bands.hpp>
#include <zonal/gather/hvl.hpp>

#include "bands.hpp"
#include "cached_gatherer.hpp"

namespace example::hvl_render {

/// Whether a pair is compiled in: all that is offered, or, in the test command's short build, what tests and the
/// report's quick data ask for.
constexpr bool is_compiled([[maybe_unused]] zonal::Horizon horizon, int bands, int emission_bands) {
#ifdef ZONAL_QUICK
  if (horizon == zonal::Horizon::smoothstep && bands == 5 && emission_bands == 1) return true;
  if (emission_bands != 3 || (horizon != zonal::Horizon::smoothstep ? bands != 5 : bands % 2 == 0 || bands == 1))
    return false;
#endif
  return contains(compiled_bands, bands) && contains(compiled_emission_bands, emission_bands);
}

/// use(N, NE) for these numbers of bands; not at all for numbers that are not compiled in.
template <zonal::Horizon H, class Use>
void dispatch_hvl(int bands, int emission_bands, const Use& use) {
  zonal::dispatch_bands<1, compiled_bands.back()>(bands, [&](auto n) {
    zonal::dispatch_bands<1, compiled_emission_bands.back()>(emission_bands, [&](auto ne) {
      if constexpr (is_compiled(H, n, ne)) use(n, ne);
    });
  });
}

/// F of an isotropic material at a hit, in the colour of its texture.
template <int N>
zonal::EvenSh<N, glm::vec3> coefficients_at(const MaterialTables& tables, const Hit& hit,
                                            const zonal::Receiver& receiver) {
  const float cos_outgoing = glm::dot(receiver.normal, receiver.outgoing);
  auto coefficients = tables.receiving[hit.material].template with_cosine<N>(cos_outgoing);
  if (const auto parts = tables.parts.find(hit.material); parts != tables.parts.end()) {
    coefficients += hit.colour * parts->second.receiving->template with_cosine<N>(cos_outgoing);
  }
  return coefficients;
}

template <int N, int NE, zonal::Horizon H>
glm::vec3 gather_at(const MaterialTables& tables, const zonal::HvlCache<NE>& cache, const zonal::Receiver& receiver,
                    const Hit& hit, const zonal::Visibility& visible) {
  if (const auto& anisotropic = tables.anisotropic[hit.material]) {
    return zonal::gather<N, NE, H>(cache, receiver, *anisotropic, visible);
  }
  return zonal::gather<N, NE, H>(cache, receiver, coefficients_at<N>(tables, hit, receiver), visible);
}

template <int N, int NE, zonal::Horizon H>
std::unique_ptr<Gatherer> make_hvl(const GatherInput& input) {
  const auto gather = [&tables = input.materials](const auto& cache, const zonal::Receiver& receiver, const Hit& hit,
                                                  std::size_t, const zonal::Visibility& visible) {
    return gather_at<N, NE, H>(tables, cache, receiver, hit, visible);
  };
  return make_cached(input, zonal::HvlCache<NE>(lit(input.map)), gather);
}

/// Null for numbers of bands that are not compiled in, here and below.
template <zonal::Horizon H>
std::unique_ptr<Gatherer> make_hvl(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer;
  dispatch_hvl<H>(input.options.bands, input.options.emission_bands,
                  [&](auto n, auto ne) { gatherer = make_hvl<n, ne, H>(input); });
  return gatherer;
}

std::unique_ptr<Gatherer> make_hvl_zonal(const GatherInput& input);

}  // namespace example::hvl_render
