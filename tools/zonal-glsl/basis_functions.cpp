#include "shader_functions.hpp"

namespace zonal_glsl {

void append_basis_functions(std::vector<zonal::shader::FunctionEntry>& entries);

void append_basis_functions(std::vector<zonal::shader::FunctionEntry>& entries) {
  zonal::shader::append_functions<zonal::kernels::BasisKernels>(entries);
  zonal::shader::append_functions<zonal::kernels::ColourKernels>(entries);
}

}  // namespace zonal_glsl
