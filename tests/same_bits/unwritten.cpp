#include "kernel_runs.hpp"

std::vector<same_bits::KernelRuns> same_bits::unwritten_kernels() { return all_of(zonal::kernels::UnwrittenKernels{}); }
