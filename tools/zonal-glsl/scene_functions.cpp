#include "shader_functions.hpp"

namespace zonal_glsl {

void append_scene_functions(std::vector<zonal::glsl::FunctionEntry>& entries);

void append_scene_functions(std::vector<zonal::glsl::FunctionEntry>& entries) {
  zonal::glsl::append_functions<zonal::glsl::SceneFunctions>(entries);
}

}  // namespace zonal_glsl
