#include "shader_functions.hpp"

namespace zonal_glsl {

void append_basis_functions(std::vector<zonal::glsl::FunctionEntry>& entries);

void append_basis_functions(std::vector<zonal::glsl::FunctionEntry>& entries) {
  zonal::glsl::append_functions<zonal::glsl::BasisFunctions>(entries);
  zonal::glsl::append_functions<zonal::glsl::ColourFunctions>(entries);
}

}  // namespace zonal_glsl
