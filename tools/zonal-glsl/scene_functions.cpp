#include "shader_functions.hpp"

namespace zonal_glsl {

void append_scene_functions(std::vector<zonal::shader::FunctionEntry>& entries);

void append_scene_functions(std::vector<zonal::shader::FunctionEntry>& entries) {
  zonal::shader::append_functions<zonal::kernels::SceneKernels>(entries);
}

}  // namespace zonal_glsl
