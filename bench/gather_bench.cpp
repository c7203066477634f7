// The HVL gather, per light.

#include <zonal/gather/hvl.hpp>

#include "bench.hpp"

namespace zonal_bench {
namespace {

using zonal::Horizon;
using zonal::MaterialTable;

glm::vec3 to_glm(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

glm::vec3 random_point(Random& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  return {uniform(random), uniform(random), uniform(random)};
}

// Any numbers will do: nothing branches on them.
MaterialTable random_material(Random& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<zonal::BrdfProjection<MaterialTable::max_bands>> rows(MaterialTable::max_angles);
  for (auto& row : rows) {
    for (auto* coefficients : {&row.with_cosine, &row.without_cosine}) {
      for (auto& c : *coefficients) c = {uniform(random), uniform(random), uniform(random)};
    }
  }
  return {rows, MaterialTable::max_bands};
}

// Lights and receivers in one cube, facing anywhere.
std::vector<zonal::VirtualLight> random_lights(Random& random, int count, const MaterialTable& material) {
  std::vector<zonal::VirtualLight> lights(static_cast<std::size_t>(count));
  for (auto& light : lights) {
    light.position = random_point(random);
    light.normal = to_glm(random_direction(random));
    light.to_primary = glm::normalize(light.normal + 0.9F * to_glm(random_direction(random)));
    light.flux = glm::vec3(2) + random_point(random);
    light.radius = 0.1F;
    light.material = &material;
  }
  return lights;
}

std::vector<zonal::Receiver> random_receivers(Random& random, int count, const MaterialTable& material) {
  std::vector<zonal::Receiver> receivers(static_cast<std::size_t>(count));
  for (auto& receiver : receivers) {
    receiver.position = random_point(random);
    receiver.normal = to_glm(random_direction(random));
    receiver.outgoing = glm::normalize(receiver.normal + 0.9F * to_glm(random_direction(random)));
    receiver.material = &material;
  }
  return receivers;
}

// One light's share of gather: its radiance and the addition of it. What is done once per receiver does not count.
template <int N, int NE, Horizon method>
zonal::OperationCount count_gather() {
  using zonal::Recorder;
  zonal::Recording recording;
  const auto fill = [&](auto& values) {
    for (auto& value : values) value = recording.input("input");
  };
  zonal::HvlRecord<NE, Recorder> light;
  for (int i = 0; i < light.field_count; ++i) light.field(i) = recording.input("light");
  zonal::ReceiverFrame<Recorder> frame;
  fill(frame.position);
  fill(frame.normal);
  fill(frame.tangent);
  Random random(1);
  const auto material = random_material(random).with_cosine<N>(0.5F);

  Recorder sum[3], radiance[3];
  fill(sum);
  zonal::hvl_radiance<N, NE, method>(light, frame, material, radiance);
  for (int c = 0; c < 3; ++c) sum[c] = sum[c] + radiance[c];
  return recording.count(sum, sum + 3);
}

template <int N, int NE, Horizon method>
void run_gather(benchmark::State& state) {
  const int light_count = static_cast<int>(state.range(0));
  Random random(1);
  const auto material = random_material(random);
  const zonal::HvlCache<NE> cache(random_lights(random, light_count, material));
  if (cache.size() != light_count) return state.SkipWithError("a light is missing from the cache");
  const auto receivers = random_receivers(random, 64, material);
  for (auto _ : state) {
    for (const auto& receiver : receivers) {
      benchmark::DoNotOptimize(zonal::gather<N, NE, method>(cache, receiver));
    }
  }
  set_counters(state, count_gather<N, NE, method>(), light_count * static_cast<int>(receivers.size()));
}

// "gather-horizon-emission bands/packet/bands/lights"
template <int N, int NE, Horizon method>
void register_one(const std::string& horizon, const Effort& effort) {
  const std::string name = "gather-" + horizon + "-" + std::to_string(NE) + "/packet/" + std::to_string(N);
  effort.apply(
      benchmark::RegisterBenchmark(name.c_str(), run_gather<N, NE, method>)->Arg(64)->Arg(196)->Arg(400));
}

template <int N>
void register_emissions(const Effort& effort) {
  register_one<N, 3, Horizon::smoothstep>("smoothstep", effort);
  register_one<N, 1, Horizon::smoothstep>("smoothstep", effort);
}

}  // namespace

void register_gather(const Effort& effort) {
  register_emissions<3>(effort);
  register_emissions<5>(effort);
  register_emissions<7>(effort);
  register_emissions<9>(effort);
  register_one<5, 3, Horizon::none>("none", effort);
  register_one<5, 3, Horizon::exact>("exact", effort);
}

}  // namespace zonal_bench
