// The tree of many lights: to build it, to bring moved lights up to date, to cut it for eight receivers and to draw.
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/named.hpp>

#include "bench.hpp"
#include "many_lights_scene.hpp"

namespace zonal_bench {
namespace {

using Cut = zonal::LightCut<cut_bands, 1>;

/// A wall that a spotlight falls on, and the floor before it.
struct Wall {
  zonal::MaterialTable clay = zonal::project_material(zonal::matte({0.8F, 0.4F, 0.2F}), cut_bands);
  std::vector<zonal::VirtualLight> lights;
  zonal::CutReceivers<cut_bands> receivers;
  zonal::ReceiverBox box;

  explicit Wall(int count) : lights(std::size_t(count)) {
    const int side = int(std::sqrt(double(count)));
    for (int i = 0; i < count; ++i) {
      zonal::VirtualLight& light = lights[std::size_t(i)];
      light.position = {4 * float(i % side) / float(side) - 2, 3, 3 * float(i / side) / float(side) + 0.1F};
      light.normal = {0, -1, 0};
      light.to_primary = glm::normalize(glm::vec3(0, 0, 4) - light.position);
      light.flux = glm::vec3(10) / float(count);
      light.radius = 3 / float(side);
      light.material = &clay;
    }
    zonal::BoundedReceiver<cut_bands, float> eight[zonal::cut_receivers];
    for (int part = 0; part < zonal::cut_receivers; ++part) {
      const zonal::Receiver receiver{{0.125F * float(part), 1, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
      box.add(receiver.position, receiver.normal);
      eight[part] = zonal::bounded_receiver(receiver, about_axis(clay.with_cosine<cut_bands>(0.8F)));
    }
    receivers = zonal::as_packet(eight);
  }
};

void count_items(benchmark::State& state, int items) {
  state.counters[time_counter] =
      benchmark::Counter(double(items), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = 1;
}

void run_build(benchmark::State& state, int count) {
  const Wall wall(count);
  const zonal::HvlCache<1> cache(wall.lights);
  for (auto _ : state) benchmark::DoNotOptimize(zonal::HvlTree<1>(cache).size());
  count_items(state, count);
}

/// Lights far from one another swing to and fro, by a hundredth of the wall: their cache, and the tree.
void run_update(benchmark::State& state, int count, int moved) {
  Wall wall(count);
  zonal::HvlCache<1> cache(wall.lights);
  zonal::HvlTree<1> tree(cache);
  std::vector<int> changed;
  for (int i = 0; i < moved; ++i) changed.push_back(int((long(i) * 2654435761L) % count));
  float step = 0.04F;
  for (auto _ : state) {
    for (const int i : changed) {
      wall.lights[std::size_t(i)].position.x += step;
      if (!cache.replace(i, wall.lights[std::size_t(i)])) state.SkipWithError("no such light");
    }
    tree.update(cache, changed);
    step = -step;
    benchmark::ClobberMemory();
  }
  count_items(state, moved);
}

void run_cut(benchmark::State& state, int count) {
  const Wall wall(count);
  const zonal::HvlTree<1> tree{zonal::HvlCache<1>(wall.lights)};
  Cut cut(tree.tree());
  for (auto _ : state) cut.find(wall.receivers, {0.01F});
  count_items(state, cut.size());
}

void run_draw(benchmark::State& state, int count) {
  const Wall wall(count);
  const zonal::HvlTree<1> tree{zonal::HvlCache<1>(wall.lights)};
  Cut cut(tree.tree());
  cut.find(wall.receivers, {0.01F});
  std::vector<zonal::DrawnLights<1>> draws(4);
  std::uint64_t seed = 0;
  for (auto _ : state) tree.draw(cut, wall.box, ++seed, draws);
  count_items(state, 4 * cut.size());
}

}  // namespace

void register_many_lights(const Effort& effort) {
  const auto one = [](benchmark::State& state, int count) { run_update(state, count, 1); };
  const auto many = [](benchmark::State& state, int count) { run_update(state, count, count / 100); };
  const std::array<std::function<void(benchmark::State&, int)>, tree_steps.size()> runs{run_build, one, many, run_cut,
                                                                                        run_draw};
  for (const int count : tree_lights) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      register_benchmark(
          tree_steps[i].name, cut_bands, std::to_string(count).c_str(),
          [run = runs[i], count](benchmark::State& state) { run(state, count); }, effort);
    }
  }
}

}  // namespace zonal_bench
