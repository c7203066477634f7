#include "run_from_list.hpp"

bool run_basis_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs);

bool run_basis_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs) {
  return run_from_list<zonal::kernels::BasisKernels>(function, bands, order, inputs, outputs) ||
         run_from_list<zonal::kernels::ColourKernels>(function, bands, order, inputs, outputs);
}
