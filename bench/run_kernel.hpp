// How a kernel is measured: many different inputs, one loop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <zonal/kernels/plain_io.hpp>
#include <zonal/kernels/sampler.hpp>
#include <zonal/scalar/packet.hpp>

#include "bench.hpp"
#include "kernel_facts.hpp"

namespace zonal_bench {

/// A scalar's name in a benchmark's name, how many items it holds, and how to set one of them.
template <class T>
struct Scalar {
  static constexpr std::size_t lanes = 1;
  static constexpr auto name = sizeof(T) == sizeof(float) ? "float" : "double";
  static void set(T& x, std::size_t, double value) { x = static_cast<T>(value); }
};
template <int W>
struct Scalar<zonal::Packet<float, W>> {
  static constexpr std::size_t lanes = W;
  static constexpr auto name = "packet";
  static void set(zonal::Packet<float, W>& x, std::size_t lane, double value) {
    x.set(static_cast<int>(lane), static_cast<float>(value));
  }
};

/// The inputs of a kernel's runs, one after the other, and room for what a run gives.
template <class T>
struct KernelData {
  std::vector<T> inputs, outputs;
  std::size_t input_size = 0, runs = 0;
};

/// Inputs of a kernel, the same every time: half of what the smallest first-level caches hold.
template <class T>
KernelData<T> draw_data(const KernelFacts& facts, int bands) {
  using zonal::kernels::Direction;
  KernelData<T> data;
  for (const auto& p : facts.parameters) {
    const auto size = static_cast<std::size_t>(p.size());
    if (p.direction != Direction::out) data.input_size += size;
    if (p.direction != Direction::in) data.outputs.resize(data.outputs.size() + size);
  }
  const std::size_t size = std::max(data.input_size, std::size_t{1}) * sizeof(T);
  data.runs = std::max(std::size_t{16 * 1024} / size, std::size_t{1});
  data.inputs.resize(data.runs * data.input_size);
  zonal::kernels::InputSampler sampler(1, bands, zonal::kernels::Draw::ordinary);
  for (std::size_t run = 0; run < data.runs; ++run) {
    for (std::size_t lane = 0; lane < Scalar<T>::lanes; ++lane) {
      T* input = data.inputs.data() + run * data.input_size;
      for (const double number : sampler.draw(facts.parameters)) Scalar<T>::set(*input++, lane, number);
    }
  }
  return data;
}

/// The loop that is measured.
template <class Entry, int N, class T>
void run_on_all(KernelData<T>& data) {
  T* const outputs = data.outputs.data();
  const T* readable = outputs;  // from anywhere
  benchmark::DoNotOptimize(readable);
  const T* inputs = data.inputs.data();
  for (std::size_t i = data.runs; i > 0; --i, inputs += data.input_size) {
    zonal::kernels::run_plainly<Entry, N>(inputs, outputs);
    benchmark::ClobberMemory();  // what it gives must then stand in memory
  }
}

using GiveFacts = KernelFacts (*)();

/// A benchmark by its loop.
template <class T>
Benchmark* register_loop(const char* name, int bands, void (*loop)(KernelData<T>&), GiveFacts facts,
                         const Effort& effort) {
  const auto body = [=](benchmark::State& state) {
    const KernelFacts of_entry = facts();
    KernelData<T> data = draw_data<T>(of_entry, bands);
    for (auto _ : state) loop(data);
    set_counters(state, of_entry.count, data.runs * Scalar<T>::lanes, Scalar<T>::lanes);
    state.counters[fused_counter] = of_entry.count.fused;
    state.counters[loads_counter] = static_cast<double>(data.input_size);
    state.counters[stores_counter] = static_cast<double>(data.outputs.size());
  };
  return register_benchmark(name, bands, Scalar<T>::name, body, effort);
}

/// A benchmark of an entry in one scalar.
template <class Entry, int N, class T>
Benchmark* register_kernel(GiveFacts facts, const Effort& effort) {
  return register_loop<T>(Entry::name, N, run_on_all<Entry, N, T>, facts, effort);
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
    register_kernel<typename Kernel::Entry, Kernel::bands, T>([] { return find_facts(Kernel::name, Kernel::bands); },
                                                              effort);
  }
};

}  // namespace zonal_bench
