// Colours with derivatives, each of 16-bit coefficients of its own, beside a copy of as many bytes.
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

#include <zonal/transform/reconstruct_adjoint_batch.hpp>

#include "bench.hpp"
#include "built_bands.hpp"

namespace zonal_bench {
namespace {

using zonal::Half;

constexpr std::size_t count = is_quick ? 1000 : 1000000;

/// What a step of training reads and writes: 120 bytes each per direction, at 4 bands.
template <int N>
struct Splats {
  static constexpr std::size_t size = 3 * N * N;
  std::vector<Half> sh = std::vector<Half>(count * size), by_sh = sh;
  std::vector<float> directions = std::vector<float>(3 * count), by_value = directions, value = directions,
                     by_direction = directions;

  Splats() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (Half& coefficient : sh) coefficient = zonal::to_half(uniform(random));
    for (float& x : directions) x = uniform(random);
    for (float& x : by_value) x = uniform(random);
  }
};

template <int N, class Run>
void run_splats(benchmark::State& state, Run run) {
  Splats<N> splats;
  for (auto _ : state) {
    run(splats);
    benchmark::ClobberMemory();
  }
  state.counters[time_counter] = benchmark::Counter(
      static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = zonal::kNativeLanes;
}

template <class T>
void copy(const std::vector<T>& from, std::vector<T>& to) {
  std::memcpy(to.data(), from.data(), from.size() * sizeof(T));
}
template <int N>
void run_copy(benchmark::State& state) {
  run_splats<N>(state, [](Splats<N>& splats) {
    copy(splats.sh, splats.by_sh);
    copy(splats.directions, splats.by_direction);
    copy(splats.by_value, splats.value);
  });
}
template <int N>
void run_adjoint(benchmark::State& state) {
  run_splats<N>(state, [](Splats<N>& splats) {
    zonal::reconstruct_with_adjoint<N, zonal::ColourRule::splat>(
        zonal::ColourBatch<Half>{splats.sh.data(), splats.directions.data(), splats.by_value.data(), count},
        zonal::AdjointBatch<Half>{splats.value.data(), splats.by_sh.data(), splats.by_direction.data()});
  });
}

}  // namespace

void register_adjoint(const Effort& effort) {
  for_bands(Built<Bands<3, 4>, Bands<4>>{}, [&](auto n) {
    register_benchmark("splats-copy", n, "halves", run_copy<n>, effort);
    register_benchmark("splats-adjoint", n, "halves", run_adjoint<n>, effort);
  });
}

}  // namespace zonal_bench
