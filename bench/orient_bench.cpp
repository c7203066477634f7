// A zonal lobe turned to an axis.
#include "kernels.hpp"
#include "run_kernel.hpp"

void zonal_bench::register_orient(const Effort& effort) { for_orient_kernels(RegisterKernel{effort}); }
