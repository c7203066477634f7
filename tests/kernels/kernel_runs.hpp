// The kernels of the registry in every scalar, compiled once: a pointer to each, for tests that are no templates.
#pragma once

#include <zonal/kernels/kernel_list.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/scalar/shadow.hpp>
#include <zonal/shader/recorded_function.hpp>

#include <tuple>
#include <vector>

#include "../accuracy.hpp"

using FloatPacket = zonal::Packet<float, 8>;
using DoublePacket = zonal::Packet<double, 4>;
using DoubleDual = zonal::Dual<double, 4>;
using FloatShadow = zonal::Shadow<float, double>;

template <class T>
using Run = void (*)(const T* inputs, T* outputs);

struct KernelRuns {
  const char* name;
  std::tuple<Run<float>, Run<double>, Run<long double>, Run<FloatPacket>, Run<DoublePacket>, Run<DoubleDual>,
             Run<FloatShadow>>
      runs;
  zonal::shader::RecordedFunction (*record)(const zonal::shader::Part& part);  // null where zonal-glsl has it

  template <class T>
  std::vector<T> run(const std::vector<T>& inputs, std::size_t output_count) const {
    std::vector<T> outputs(output_count);
    std::get<Run<T>>(runs)(inputs.data(), outputs.data());
    return outputs;
  }
};

// Of each list of kernel_list.hpp, in units of their own.
void append_basis_runs(std::vector<KernelRuns>& kernels);
void append_scene_runs(std::vector<KernelRuns>& kernels);
void append_unwritten_runs(std::vector<KernelRuns>& kernels);

template <class Entry, class T>
inline constexpr Run<T> run_of = zonal::kernels::run_plainly<Entry, run_bands, T>;
template <class Entry>
KernelRuns runs_of(decltype(KernelRuns::record) record = nullptr) {
  return {Entry::name,
          {run_of<Entry, float>, run_of<Entry, double>, run_of<Entry, long double>, run_of<Entry, FloatPacket>,
           run_of<Entry, DoublePacket>, run_of<Entry, DoubleDual>, run_of<Entry, FloatShadow>},
          record};
}
