// The zonal coefficients of a spherical cap, in the three forms that HVL Fig. 6 compares.
#include "kernels.hpp"
#include "run_kernel.hpp"

void zonal_bench::register_cap(const Effort& effort) { for_cap_kernels(RegisterKernel{effort}); }
