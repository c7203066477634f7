#include "bench.hpp"

#include <set>

namespace zonal_bench {

std::string kernel_name(const std::string& name, int bands) { return name + "/" + std::to_string(bands); }

Benchmark* register_benchmark(const std::string& name, int bands, const char* scalar, const Body& body,
                              const Effort& effort) {
  static std::set<std::string> names;
  const std::string full_name = kernel_name(name, bands) + "/" + scalar;
  if (!names.insert(full_name).second) return nullptr;
  auto* benchmark = benchmark::RegisterBenchmark(full_name.c_str(), body);
  if (effort.seconds > 0) benchmark->MinTime(effort.seconds);
  if (effort.repetitions > 0) benchmark->Repetitions(effort.repetitions);
  return benchmark;
}

void set_counters(benchmark::State& state, const zonal::OperationCount& count, std::size_t items, std::size_t lanes) {
  const std::array counts{count.additions, count.multiplications, count.divisions, count.functions, count.comparisons};
  for (std::size_t i = 0; i < counts.size(); ++i) state.counters[operation_counters[i]] = counts[i];
  state.counters[lanes_counter] = static_cast<double>(lanes);
  using benchmark::Counter;
  state.counters[time_counter] =
      Counter(static_cast<double>(items), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

}  // namespace zonal_bench
