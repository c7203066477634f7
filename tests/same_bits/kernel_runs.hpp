// The kernels of the registry in the scalars that must agree to the bit, as pointers.
#pragma once

#include <zonal/kernels/kernel_list.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/scalar/packet.hpp>

#include <cstddef>
#include <tuple>
#include <vector>

namespace same_bits {

inline constexpr int kBands = 4;  // as tests/kernels, which has the same hashes

template <class T>
using Run = void (*)(const T* inputs, T* outputs);

struct KernelRuns {
  const char* name;
  std::vector<zonal::kernels::Parameter> parameters;
  std::size_t output_count;
  std::tuple<Run<float>, Run<double>, Run<zonal::Packet<float, 4>>, Run<zonal::Packet<float, 16>>,
             Run<zonal::Packet<double, 4>>>
      runs;

  template <class T>
  std::vector<T> run(const std::vector<T>& inputs) const {
    std::vector<T> outputs(output_count, T(0));
    std::get<Run<T>>(runs)(inputs.data(), outputs.data());
    return outputs;
  }
};

template <class Entry, class T>
inline constexpr Run<T> run_of = zonal::kernels::run_plainly<Entry, kBands, T>;

template <class Entry>
KernelRuns runs_of() {
  using namespace zonal::kernels;
  DescribingIo<float> io([](const Parameter&) { return 0.5F; });
  Entry::template run<kBands>(io);
  std::size_t outputs = 0;
  for (const Parameter& p : io.parameters()) {
    outputs += p.direction == Direction::in ? 0 : static_cast<std::size_t>(p.size());
  }
  return {Entry::name,
          io.parameters(),
          outputs,
          {run_of<Entry, float>, run_of<Entry, double>, run_of<Entry, zonal::Packet<float, 4>>,
           run_of<Entry, zonal::Packet<float, 16>>, run_of<Entry, zonal::Packet<double, 4>>}};
}

template <class List>
std::vector<KernelRuns> all_of(List list) {
  std::vector<KernelRuns> all;
  zonal::kernels::for_each_kernel(list, [&](auto entry) { all.push_back(runs_of<decltype(entry)>()); });
  return all;
}

// In units of their own, which take long to compile.
std::vector<KernelRuns> basis_kernels();
std::vector<KernelRuns> scene_kernels();
std::vector<KernelRuns> unwritten_kernels();

}  // namespace same_bits
