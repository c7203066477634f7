#include "kernel_runs.hpp"

void append_unwritten_runs(std::vector<KernelRuns>& kernels) {
  zonal::kernels::for_each_kernel(zonal::kernels::UnwrittenKernels{}, [&](auto entry) {
    using Entry = decltype(entry);
    constexpr int bands = Entry::has_bands ? run_bands : 1;
    kernels.push_back(runs_of<Entry>(zonal::shader::record<Entry, bands>));
  });
}
