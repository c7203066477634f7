#include "kernel_runs.hpp"

std::vector<same_bits::KernelRuns> same_bits::basis_kernels() { return all_of(zonal::kernels::BasisKernels{}); }
