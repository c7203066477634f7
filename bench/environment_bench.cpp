// Pictures of all directions to coefficients, in every mapping, beside adding up as many texels.
#include <cstddef>
#include <random>
#include <vector>

#include <zonal/environment/project.hpp>
#include <zonal/scalar/lanes.hpp>

#include "bench.hpp"
#include "built_bands.hpp"
#include "environment_pictures.hpp"

namespace zonal_bench {
namespace {

using EnvironmentBands = Built<Bands<5, 20>, Bands<5>>;

std::vector<float> random_texels(const EnvironmentPicture& picture) {
  std::vector<float> numbers(3 * texel_count(picture));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (float& number : numbers) number = uniform(random);
  return numbers;
}

void count_texels(benchmark::State& state, const EnvironmentPicture& picture) {
  state.counters[time_counter] =
      benchmark::Counter(static_cast<double>(texel_count(picture)),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = zonal::kNativeLanes;
}

// As fast as memory gives them: twelve sums of lanes, and the channels told apart at the end.
std::vector<double> sum_of_texels(const std::vector<float>& numbers) {
  constexpr std::size_t lanes = zonal::kNativeLanes, sums = 12;
  using L = zonal::Lanes<float, zonal::kNativeLanes>;
  L total[sums];
  for (L& sum : total) sum = L(0);
  std::size_t i = 0;
  for (; i + sums * lanes <= numbers.size(); i += sums * lanes) {
    for (std::size_t k = 0; k < sums; ++k) total[k] = total[k] + L::load(numbers.data() + i + k * lanes);
  }
  float parts[sums * lanes];
  for (std::size_t k = 0; k < sums; ++k) total[k].store(parts + k * lanes);
  std::vector<double> channels(3);
  for (std::size_t k = 0; k < sums * lanes; ++k) channels[k % 3] += double(parts[k]);
  for (; i < numbers.size(); ++i) channels[i % 3] += double(numbers[i]);
  return channels;
}

void run_sum(benchmark::State& state, const EnvironmentPicture& picture) {
  const std::vector<float> numbers = random_texels(picture);
  for (auto _ : state) {
    auto sum = sum_of_texels(numbers);
    benchmark::DoNotOptimize(sum.data());
    benchmark::ClobberMemory();
  }
  count_texels(state, picture);
}

template <int N>
void run_project(benchmark::State& state, const EnvironmentPicture& picture) {
  const std::vector<float> numbers = random_texels(picture);
  const zonal::Environment environment(zonal::Picture<const float>::of(numbers, picture.width, picture.height),
                                       picture.mapping);
  for (auto _ : state) {
    auto sh = zonal::project<N>(environment);
    benchmark::DoNotOptimize(sh);
  }
  count_texels(state, picture);
}

}  // namespace

void register_environment(const Effort& effort) {
  for (const EnvironmentPicture& picture : environment_pictures()) {
    const char* name = zonal::mapping_name(picture.mapping);
    register_benchmark(
        "environment-sum", 0, name, [=](auto& state) { run_sum(state, picture); }, effort);
    for_bands(EnvironmentBands{}, [&](auto n) {
      register_benchmark(
          "environment", n, name, [=](auto& state) { run_project<n>(state, picture); }, effort);
    });
  }
}

}  // namespace zonal_bench
