// What the benchmarks share: random inputs, the measured loop, the operation counts, and how they are registered.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <zonal/scalar/packet.hpp>
#include <zonal/scalar/recorder.hpp>
#include <zonal/scalar/unroll.hpp>

namespace zonal_bench {

using Random = std::mt19937;
using NativePacket = zonal::Packet<float, zonal::kNativeLanes>;

/// Repetitions of at least so many seconds; zeros leave both to Google Benchmark and its flags.
struct Effort {
  double seconds = 0;
  int repetitions = 0;

  template <class Benchmark>
  void apply(Benchmark* benchmark) const {
    if (seconds > 0) benchmark->MinTime(seconds);
    if (repetitions > 0) benchmark->Repetitions(repetitions);
  }
};

void register_evaluate(const Effort& effort);
void register_cap(const Effort& effort);
void register_orient(const Effort& effort);
void register_gather(const Effort& effort);

/// The counters of every benchmark: operations and time per item, that is per direction, cap or light.
inline constexpr std::array counter_names{"add", "mul", "div", "fun", "cmp"};
inline constexpr const char* time_counter = "each";

inline void set_counters(benchmark::State& state, const zonal::OperationCount& count, int items) {
  const std::array counts{count.additions, count.multiplications, count.divisions, count.functions,
                          count.comparisons};
  for (std::size_t i = 0; i < counts.size(); ++i) state.counters[counter_names[i]] = counts[i];
  using benchmark::Counter;
  state.counters[time_counter] = Counter(items, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// A scalar's name in a benchmark's name, how many items it holds, and how to set one of them.
template <class T>
struct Scalar;
template <>
struct Scalar<float> {
  static constexpr const char* name = "float";
  static constexpr int lanes = 1;
  static void set(float& x, int, double value) { x = static_cast<float>(value); }
};
template <>
struct Scalar<double> {
  static constexpr const char* name = "double";
  static constexpr int lanes = 1;
  static void set(double& x, int, double value) { x = value; }
};
template <>
struct Scalar<NativePacket> {
  static constexpr const char* name = "packet";
  static constexpr int lanes = NativePacket::width;
  static void set(NativePacket& x, int lane, double value) { x.set(lane, static_cast<float>(value)); }
};

inline std::array<double, 3> random_direction(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

// A kernel is a struct with
//   inputs         how many numbers it takes
//   draw(random)   such numbers, as an array of double
//   run(numbers)   what it makes of an array of them, an Sh or Zh, for any scalar

template <class Kernel>
zonal::OperationCount count_operations() {
  zonal::Recording recording;
  std::array<zonal::Recorder, Kernel::inputs> inputs;
  for (auto& input : inputs) input = recording.input("input");
  const auto result = Kernel::run(inputs);
  return recording.count(result.begin(), result.end());
}

/// Half of the smallest first-level cache in use: all inputs stay there, beside the results.
inline constexpr int input_bytes = 16 * 1024;

/// Many different inputs of the kernel, the same in every run.
template <class Kernel, class T>
std::vector<std::array<T, Kernel::inputs>> random_inputs() {
  std::vector<std::array<T, Kernel::inputs>> inputs(input_bytes / sizeof(std::array<T, Kernel::inputs>));
  Random random(1);
  for (auto& input : inputs) {
    for (int lane = 0; lane < Scalar<T>::lanes; ++lane) {
      const auto numbers = Kernel::draw(random);
      for (std::size_t i = 0; i < numbers.size(); ++i) Scalar<T>::set(input[i], lane, numbers[i]);
    }
  }
  return inputs;
}

template <class Kernel, class T>
void run_kernel(benchmark::State& state) {
  const auto inputs = random_inputs<Kernel, T>();
  for (auto _ : state) {
    for (const auto& input : inputs) {
      const auto result = Kernel::run(input);
      // The address alone: then the whole result must stand in memory, but is not copied once more.
      const auto* address = &result;
      benchmark::DoNotOptimize(address);
    }
  }
  set_counters(state, count_operations<Kernel>(), static_cast<int>(inputs.size()) * Scalar<T>::lanes);
}

/// "name/scalar/bands" for each of the scalars.
template <class Kernel>
void register_kernel(const std::string& name, int bands, const Effort& effort) {
  const auto add = [&](auto scalar) {
    using T = decltype(scalar);
    const std::string full_name = name + "/" + Scalar<T>::name + "/" + std::to_string(bands);
    effort.apply(benchmark::RegisterBenchmark(full_name.c_str(), run_kernel<Kernel, T>));
  };
  add(float());
  add(double());
  add(NativePacket());
}

/// The same for 1 to Last bands.
template <template <int> class Kernel, int Last>
void register_kernels(const std::string& name, const Effort& effort) {
  zonal::unroll<1, Last + 1>([&](auto n) { register_kernel<Kernel<n>>(name, n, effort); });
}

}  // namespace zonal_bench
