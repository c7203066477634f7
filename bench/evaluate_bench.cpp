// The basis at a direction, by the recurrences and by explicit polynomials.
#include "kernels.hpp"
#include "run_kernel.hpp"

void zonal_bench::register_evaluate(const Effort& effort) { for_evaluate_kernels(RegisterKernel{effort}); }
