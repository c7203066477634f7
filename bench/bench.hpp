// What the benchmarks share. What is measured: kernels.hpp, registry_bench.cpp; the loop that measures it:
// run_kernel.hpp.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <zonal/scalar/recorder.hpp>

namespace zonal_bench {

/// Repetitions of at least so many seconds each; zeros leave both to Google Benchmark and its flags.
struct Effort {
  double seconds = 0;
  int repetitions = 0;
};

void register_evaluate(const Effort& effort);
void register_cap(const Effort& effort);
void register_orient(const Effort& effort);
void register_gather(const Effort& effort);
void register_gradient(const Effort& effort);
void register_grid(const Effort& effort);
void register_batch(const Effort& effort);
void register_adjoint(const Effort& effort);
void register_environment(const Effort& effort);
void register_screen(const Effort& effort);
void register_many_lights(const Effort& effort);
void register_many_bands(const Effort& effort);
/// Every kernel of the registry that the others have left out: they come first.
void register_registry(const Effort& effort);
/// All kernels of the registry, in its order: the names of their benchmarks, less the scalar's.
std::vector<std::string> registry_names();

/// The counters of every benchmark, per item, that is per direction, cap or light: how many operations of
/// each kind the recorder has counted, and seconds.
inline constexpr std::array operation_counters{"add", "mul", "div", "fun", "cmp"};
inline constexpr const char* time_counter = "each";
/// The counters of the registry's kernels: what else their limit is found from, limits.hpp.
inline constexpr const char *fused_counter = "fused", *loads_counter = "loads", *stores_counter = "stores";
/// How many items one run of the kernel does.
inline constexpr const char* lanes_counter = "lanes";

/// The numbers of lights that are gathered, as in HVL Table 1.
inline constexpr std::array gather_lights{64, 196, 400};

/// "name/bands".
std::string kernel_name(const std::string& name, int bands);

using Body = std::function<void(benchmark::State&)>;
// Google Benchmark has moved it between namespaces.
using Benchmark = std::remove_pointer_t<decltype(benchmark::RegisterBenchmark("", std::declval<Body>()))>;

/// A benchmark "name/bands/scalar"; null where there is one of that name.
Benchmark* register_benchmark(const std::string& name, int bands, const char* scalar, const Body& body,
                              const Effort& effort);

/// Sets them; `items` is how many one iteration goes through.
void set_counters(benchmark::State& state, const zonal::OperationCount& count, std::size_t items, std::size_t lanes);

}  // namespace zonal_bench
