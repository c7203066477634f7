// The HVL gather, in time per light.
#include "bench.hpp"
#include "gather_kernels.hpp"
#include "gather_scene.hpp"
#include "kernel_facts.hpp"

namespace zonal_bench {
namespace {

using zonal::MaterialTable;

template <class Kernel>
void run_gather(benchmark::State& state) {
  using Entry = typename Kernel::Entry;
  constexpr int bands = Kernel::bands, emission_bands = Entry::emission_bands;
  const auto light_count = static_cast<std::size_t>(state.range(0));
  Random random;
  const MaterialTable material = random_material(random);
  const zonal::HvlCache<emission_bands> cache(random_lights(random, light_count, material));
  if (static_cast<std::size_t>(cache.size()) != light_count) {
    state.SkipWithError("the cache has left out a light");
    return;
  }
  const auto receivers = random_receivers(random, 64);
  for (auto _ : state) {
    for (const auto& receiver : receivers) {
      auto radiance = zonal::gather<bands, emission_bands, Entry::horizon>(cache, receiver, material);
      benchmark::DoNotOptimize(radiance);
    }
  }
  zonal::OperationCount count = find_facts(Entry::name, bands).count;
  count.additions += 3;  // to the sum over the lights
  set_counters(state, count, receivers.size() * light_count, zonal::kNativeLanes);
}

}  // namespace

void register_gather(const Effort& effort) {
  for_gather_kernels([&](auto kernel) {
    using Kernel = decltype(kernel);
    auto* benchmark =
        register_benchmark(std::string("gather_") + Kernel::name, Kernel::bands, "packet", run_gather<Kernel>, effort);
    for (int lights : gather_lights) benchmark->Arg(lights);
  });
}

}  // namespace zonal_bench
