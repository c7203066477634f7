// The basis with its gradient: by the ladder, by the papers' angles, by differentiated polynomials.
#include "kernels.hpp"
#include "run_kernel.hpp"

void zonal_bench::register_gradient(const Effort& effort) {
  for_gradient_kernels([&](auto kernel) {
    const RegisterKernel with{effort};
    with.add<decltype(kernel), float>();
    with.add<decltype(kernel), zonal::Packet<float, zonal::kNativeLanes>>();
  });
}
