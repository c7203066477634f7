// The HVL gather, in time per light.
#include <vector>

#include <zonal/kernels/sampler.hpp>

#include "bench.hpp"
#include "gather_kernels.hpp"
#include "kernel_facts.hpp"

namespace zonal_bench {
namespace {

using kernels::Domain;
using zonal::MaterialTable;

/// Vectors as the registry's kernels take them.
class Random {
 public:
  glm::vec3 unit_vector() { return vector(Domain::unit_vector); }
  glm::vec3 point() { return vector(Domain::position); }

 private:
  glm::vec3 vector(Domain domain) {
    const auto v = sampler_.draw({{"", kernels::Direction::in, domain, 3, 0}});
    return glm::vec3(glm::dvec3(v[0], v[1], v[2]));
  }
  kernels::InputSampler sampler_{1, 1, kernels::Draw::ordinary};
};

// Any numbers will do: nothing branches on them.
MaterialTable random_material(Random& random) {
  std::vector<zonal::BrdfProjection<MaterialTable::max_bands>> rows(MaterialTable::max_angles);
  for (auto& row : rows) {
    for (auto* coefficients : {&row.with_cosine, &row.without_cosine}) {
      for (glm::dvec3& c : *coefficients) c = random.point();
    }
  }
  return {rows, MaterialTable::max_bands};
}

// Lights and receivers in a cube, facing anywhere.
std::vector<zonal::VirtualLight> random_lights(Random& random, std::size_t count, const MaterialTable& material) {
  std::vector<zonal::VirtualLight> lights(count);
  for (auto& light : lights) {
    light.position = random.point();
    light.normal = random.unit_vector();
    light.to_primary = glm::normalize(light.normal + 0.9F * random.unit_vector());
    light.flux = glm::vec3(2) + random.point();
    light.radius = 0.2F + 0.1F * random.point().x;
    light.material = &material;
  }
  return lights;
}

std::vector<zonal::Receiver> random_receivers(Random& random, std::size_t count) {
  std::vector<zonal::Receiver> receivers(count);
  for (auto& receiver : receivers) {
    receiver.position = random.point();
    receiver.normal = random.unit_vector();
    receiver.outgoing = glm::normalize(receiver.normal + 0.9F * random.unit_vector());
  }
  return receivers;
}

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
