#include "gatherer.hpp"

#include <vector>

#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsgl.hpp>
#include <zonal/gather/vsl.hpp>

#include "gather_hvl.hpp"
#include "shared/input_error.hpp"
#include "shared/random.hpp"

namespace example::hvl_render {

extern template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::none>(const GatherInput& input);
extern template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::smoothstep>(const GatherInput& input);
extern template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::exact>(const GatherInput& input);

namespace {

using zonal::Receiver;
using zonal::Visibility;

std::unique_ptr<Gatherer> make_vpl(const GatherInput& input) {
  const auto gather = [&scene = input.scene, clamp = input.options.vpl_clamp](const auto& cache,
                                                                              const Receiver& receiver, const Hit& hit,
                                                                              std::size_t, const Visibility& visible) {
    return gather_vpl(cache, receiver, brdf_at(scene, hit), clamp, visible);
  };
  return make_cached(input, zonal::LightCache(lit(input.map)), gather);
}

std::unique_ptr<Gatherer> make_vsl(const GatherInput& input) {
  const auto gather = [&scene = input.scene, samples = input.options.vsl_samples, seed = hash64(input.options.seed)](
                          const auto& cache, const Receiver& receiver, const Hit& hit, std::size_t sample,
                          const Visibility& visible) {
    Pcg32 random(seed ^ static_cast<std::uint64_t>(sample));
    const auto uniform = [&random] { return random.uniform(); };
    return gather_vsl(cache, receiver, brdf_at(scene, hit), samples, uniform, visible);
  };
  return make_cached(input, zonal::LightCache(lit(input.map)), gather);
}

template <zonal::Vsgl formulas>
std::unique_ptr<Gatherer> make_vsgl(const GatherInput& input) {
  const auto gather = [&scene = input.scene](const auto& cache, const Receiver& receiver, const Hit& hit, std::size_t,
                                             const Visibility& visible) {
    return zonal::gather_vsgl<formulas>(cache, receiver, brdf_at(scene, hit), visible);
  };
  std::vector<zonal::GaussianLight> lights;
  for (const auto* map : {&input.map.lights, &input.map.bodies}) {
    if (map->empty()) continue;
    const auto part = zonal::make_gaussian_lights<formulas>(map->data(), input.map.side, block_side(input.options));
    lights.insert(lights.end(), part.begin(), part.end());
  }
  return make_cached(input, zonal::GaussianCache(lights), gather);
}

std::unique_ptr<Gatherer> make_hvl(const GatherInput& input) {
  switch (input.options.horizon) {
    case HorizonRule::none: return make_hvl<zonal::Horizon::none>(input);
    case HorizonRule::smoothstep: return make_hvl<zonal::Horizon::smoothstep>(input);
    case HorizonRule::exact: return make_hvl<zonal::Horizon::exact>(input);
  }
  return nullptr;
}

std::unique_ptr<Gatherer> make(const GatherInput& input) {
  switch (input.options.method) {
    case Method::vpl: return make_vpl(input);
    case Method::vsl: return make_vsl(input);
    case Method::vsgl: return make_vsgl<zonal::Vsgl::of_2015>(input);
    case Method::vsgl_2024: return make_vsgl<zonal::Vsgl::of_2024>(input);
    case Method::hvl: return make_hvl(input);
    case Method::hvl_zonal: return make_hvl_zonal(input);
    case Method::path: break;
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Gatherer> make_gatherer(const GatherInput& input) {
  std::unique_ptr<Gatherer> gatherer = make(input);
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

}  // namespace example::hvl_render
