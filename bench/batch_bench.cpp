// Many directions at once, in rows and in planes, beside a plain fill of as many bytes; and a sum of coloured samples.
#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include <zonal/basis/batch.hpp>

#include "bench.hpp"
#include "built_bands.hpp"

namespace zonal_bench {
namespace {

using BatchBands = Built<Bands<5, 10, 20>, Bands<5>>;

struct Sample {
  glm::vec3 direction, rgb;
};

std::vector<Sample> samples(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<Sample> all(count);
  for (Sample& sample : all) {
    const float x = normal(random), y = normal(random), z = normal(random);
    sample = {glm::normalize(glm::vec3(x, y, z)), glm::abs(glm::vec3(y, z, x))};
  }
  return all;
}

// Directions whose coefficients fill so many bytes: half of a second-level cache of today, or more than any holds.
constexpr std::size_t in_cache = std::size_t{512} << 10, beyond_caches = std::size_t{128} << 20;

// fill(directions, coefficients) for all of them.
template <int N, std::size_t bytes, class Fill>
void run_batch(benchmark::State& state, Fill fill) {
  // Whole lines in a plane, and in all.
  const std::size_t count = bytes / (sizeof(float) * N * N) / 16 * 16;
  std::vector<glm::vec3> unit_vectors;
  for (const Sample& sample : samples(count)) unit_vectors.push_back(sample.direction);
  const auto directions = zonal::direction_span(unit_vectors.data(), count);
  std::vector<float> memory(count * N * N + 16);
  float* coefficients = memory.data();
  while (reinterpret_cast<std::uintptr_t>(coefficients) % 64 != 0) ++coefficients;
  for (auto _ : state) {
    fill(directions, coefficients);
    benchmark::DoNotOptimize(coefficients);
    benchmark::ClobberMemory();
  }
  state.counters[time_counter] = benchmark::Counter(
      static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = zonal::kNativeLanes;
}

template <int N, std::size_t bytes>
void run_fill(benchmark::State& state) {
  run_batch<N, bytes>(state, [](const auto& directions, float* target) {
    std::memset(target, 1, directions.count * sizeof(float) * N * N);
  });
}
template <int N, std::size_t bytes>
void run_rows(benchmark::State& state) {
  run_batch<N, bytes>(state, [](const auto& directions, float* target) {
    zonal::evaluate<N>(directions, zonal::CoefficientRows<float>{target});
  });
}
template <int N, std::size_t bytes>
void run_planes(benchmark::State& state) {
  run_batch<N, bytes>(state, [](const auto& directions, float* target) {
    zonal::evaluate<N>(directions, zonal::CoefficientPlanes<float>{target, directions.count});
  });
}

void run_sum(benchmark::State& state) {
  const auto input = samples(1000);
  for (auto _ : state) {
    zonal::Sh<5, glm::vec3> sum{};
    for (const Sample& sample : input) sum += zonal::evaluate<5>(sample.direction) * sample.rgb;
    benchmark::DoNotOptimize(sum);
  }
  state.counters[time_counter] = benchmark::Counter(
      static_cast<double>(input.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = 1;
}

}  // namespace

void register_batch(const Effort& effort) {
  for_bands(BatchBands{}, [&](auto n) {
    register_benchmark("batch-fill", n, "cache", run_fill<n, in_cache>, effort);
    register_benchmark("batch-rows", n, "cache", run_rows<n, in_cache>, effort);
    register_benchmark("batch-planes", n, "cache", run_planes<n, in_cache>, effort);
    if (is_quick) return;  // not so much memory for times that mean nothing
    register_benchmark("batch-fill", n, "memory", run_fill<n, beyond_caches>, effort);
    register_benchmark("batch-rows", n, "memory", run_rows<n, beyond_caches>, effort);
    register_benchmark("batch-planes", n, "memory", run_planes<n, beyond_caches>, effort);
  });
  register_benchmark("sum-of-samples", 5, "float", run_sum, effort);
}

}  // namespace zonal_bench
