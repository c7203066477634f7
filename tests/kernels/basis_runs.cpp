#include "kernel_runs.hpp"

void append_basis_runs(std::vector<KernelRuns>& kernels) {
  zonal::kernels::for_each_kernel(zonal::kernels::BasisKernels{},
                                  [&](auto entry) { kernels.push_back(runs_of<decltype(entry)>()); });
}
