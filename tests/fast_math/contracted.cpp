// Compiled with -ffp-contract=fast, and with EIGEN_DONT_VECTORIZE, which gives it a namespace of its own:
// CMakeLists.txt. Without an instruction that fuses it is the same as without contraction.
#include <zonal/accuracy.hpp>

#include "chosen_kernels.hpp"

std::vector<KernelResults> contracted_results(const std::vector<std::vector<float>>& inputs, int runs) {
  return kernels_of_each_kind::results_of(kernels_of_each_kind::Kernels{}, inputs, runs);
}
