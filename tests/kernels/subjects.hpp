// The kernels of the registry with their records and promises.
#pragma once

#include <vector>

#include "kernel_checks.hpp"
#include "shader_functions.hpp"

inline const std::vector<KernelRuns>& all_kernels() {
  static const std::vector<KernelRuns> all = [] {
    std::vector<KernelRuns> kernels;
    append_basis_runs(kernels);
    append_scene_runs(kernels);
    append_unwritten_runs(kernels);
    return kernels;
  }();
  return all;
}

inline Subject subject_of(const KernelRuns& kernel) {
  return {kernel,
          kernel.record != nullptr
              ? kernel.record(zonal::shader::all_orders)
              : zonal_glsl::find_function(kernel.name)->record(run_bands, zonal::shader::all_orders),
          zonal::accuracy_of(kernel.name, zonal::accuracy::kAnyScalar, run_bands)};
}
