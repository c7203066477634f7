// A cap's zonal coefficients in three forms, and a zonal lobe turned to an axis.
#include "evaluation.hpp"

void zonal_report::print_lobes(Effort effort) {
  KernelTable caps("cap", effort), rotations("rotation", effort);
  zonal_bench::for_cap_kernels([&](auto kernel) { caps.add<decltype(kernel)>(); });
  zonal_bench::for_orient_kernels([&](auto kernel) { rotations.add<decltype(kernel)>(); });
  caps.print();
  rotations.print();
}
