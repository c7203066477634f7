// The HVL gather, in time per light.
#include <random>
#include <vector>

#include "bench.hpp"
#include "gather_kernels.hpp"
#include "kernels.hpp"

namespace zonal_bench {
namespace {

using zonal::MaterialTable;

glm::vec3 random_unit_vector(Random& random) {
  const auto v = random_direction(random);
  return {v[0], v[1], v[2]};
}

glm::vec3 random_point(Random& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  const float x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

// Any numbers will do: nothing branches on them.
MaterialTable random_material(Random& random) {
  std::vector<zonal::BrdfProjection<MaterialTable::max_bands>> rows(MaterialTable::max_angles);
  for (auto& row : rows) {
    for (auto* coefficients : {&row.with_cosine, &row.without_cosine}) {
      for (glm::dvec3& c : *coefficients) c = random_point(random);
    }
  }
  return {rows, MaterialTable::max_bands};
}

// Lights and receivers in a cube, facing anywhere.
std::vector<zonal::VirtualLight> random_lights(Random& random, std::size_t count, const MaterialTable& material) {
  std::vector<zonal::VirtualLight> lights(count);
  for (auto& light : lights) {
    light.position = random_point(random);
    light.normal = random_unit_vector(random);
    light.to_primary = glm::normalize(light.normal + 0.9F * random_unit_vector(random));
    light.flux = glm::vec3(2) + random_point(random);
    light.radius = 0.2F + 0.1F * random_point(random).x;
    light.material = &material;
  }
  return lights;
}

std::vector<zonal::Receiver> random_receivers(Random& random, std::size_t count) {
  std::vector<zonal::Receiver> receivers(count);
  for (auto& receiver : receivers) {
    receiver.position = random_point(random);
    receiver.normal = random_unit_vector(random);
    receiver.outgoing = glm::normalize(receiver.normal + 0.9F * random_unit_vector(random));
  }
  return receivers;
}

template <class Kernel>
void run_gather(benchmark::State& state) {
  const auto light_count = static_cast<std::size_t>(state.range(0));
  Random random(1);
  const MaterialTable material = random_material(random);
  const zonal::HvlCache<Kernel::emission_bands> cache(random_lights(random, light_count, material));
  if (static_cast<std::size_t>(cache.size()) != light_count) {
    state.SkipWithError("the cache has left out a light");
    return;
  }
  const auto receivers = random_receivers(random, 64);
  for (auto _ : state) {
    for (const auto& receiver : receivers) {
      auto radiance = zonal::gather<Kernel::bands, Kernel::emission_bands, Kernel::horizon>(cache, receiver, material);
      benchmark::DoNotOptimize(radiance);
    }
  }
  set_counters(state, Kernel::name, Kernel::bands, receivers.size() * light_count, zonal::kNativeLanes);
}

}  // namespace

void register_gather(const Effort& effort) {
  for_gather_kernels([&](auto kernel) {
    using Kernel = decltype(kernel);
    auto* benchmark = register_benchmark(Kernel::name, Kernel::bands, "packet", run_gather<Kernel>, effort);
    for (int lights : gather_lights) benchmark->Arg(lights);
  });
}

}  // namespace zonal_bench
