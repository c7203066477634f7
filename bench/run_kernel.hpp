// How a kernel is measured: many different inputs, one loop.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <zonal/scalar/packet.hpp>

#include "bench.hpp"
#include "kernels.hpp"

namespace zonal_bench {

/// A scalar's name in a benchmark's name, how many items it holds, and how to set one of them.
template <class T>
struct Scalar {
  static constexpr std::size_t lanes = 1;
  static constexpr const char* name = sizeof(T) == sizeof(float) ? "float" : "double";
  static void set(T& x, std::size_t, double value) { x = static_cast<T>(value); }
};
template <int W>
struct Scalar<zonal::Packet<float, W>> {
  static constexpr std::size_t lanes = W;
  static constexpr const char* name = "packet";
  static void set(zonal::Packet<float, W>& x, std::size_t lane, double value) {
    x.set(static_cast<int>(lane), static_cast<float>(value));
  }
};

/// Inputs of a domain, the same in every run: half of what the smallest first-level caches hold.
template <class Domain, class T>
auto random_inputs() {
  using Input = std::array<T, Domain::inputs>;
  std::vector<Input> inputs(16 * 1024 / sizeof(Input));
  Random random(1);
  for (Input& input : inputs) {
    for (std::size_t lane = 0; lane < Scalar<T>::lanes; ++lane) {
      const auto numbers = Domain::draw(random);
      for (std::size_t i = 0; i < numbers.size(); ++i) Scalar<T>::set(input[i], lane, numbers[i]);
    }
  }
  return inputs;
}

/// The loop that is measured.
template <class Kernel, class Inputs>
void run_on_all(const Inputs& inputs) {
  for (const auto& input : inputs) {
    const auto result = Kernel::run(input);
    // Of the address alone: the whole result must then stand in memory, but nothing copies it.
    const auto* address = &result;
    benchmark::DoNotOptimize(address);
  }
}

template <class Kernel, class T>
void run_kernel(benchmark::State& state) {
  const auto inputs = random_inputs<typename Kernel::Domain, T>();
  for (auto _ : state) run_on_all<Kernel>(inputs);
  set_counters(state, Kernel::name, Kernel::bands, inputs.size() * Scalar<T>::lanes, Scalar<T>::lanes);
}

/// Registers each kernel that it is called with, for the three scalars.
struct RegisterKernel {
  Effort effort;

  template <class Kernel>
  void operator()(Kernel) const {
    add<Kernel, float>();
    add<Kernel, double>();
    add<Kernel, zonal::Packet<float, zonal::kNativeLanes>>();
  }

  template <class Kernel, class T>
  void add() const {
    register_benchmark(Kernel::name, Kernel::bands, Scalar<T>::name, run_kernel<Kernel, T>, effort);
  }
};

}  // namespace zonal_bench
