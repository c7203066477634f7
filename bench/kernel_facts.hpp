// What the recorder says of a kernel.
#pragma once

#include <vector>

#include <zonal/kernels/kernel_io.hpp>
#include <zonal/scalar/recorder.hpp>
#include <zonal/shader/recorded_function.hpp>

namespace zonal_bench {

struct KernelFacts {
  std::vector<zonal::kernels::Parameter> parameters;
  zonal::OperationCount count;  // per item: per direction, cap or light
};

/// Of an entry of the registry's form.
template <class Entry, int N>
KernelFacts facts_of() {
  const zonal::shader::RecordedFunction function = zonal::shader::record<Entry, N>();
  return {function.parameters, function.count()};
}

/// The same of all that are timed here, by name and bands; compiled once.
const KernelFacts& find_facts(const char* name, int bands);

}  // namespace zonal_bench
