#include "shader_functions.hpp"

namespace zonal_glsl {

// Each compiled apart: they take a while.
void append_basis_functions(std::vector<zonal::shader::FunctionEntry>& entries);
void append_scene_functions(std::vector<zonal::shader::FunctionEntry>& entries);

const std::vector<zonal::shader::FunctionEntry>& shader_functions() {
  static const std::vector<zonal::shader::FunctionEntry> table = [] {
    std::vector<zonal::shader::FunctionEntry> entries;
    append_basis_functions(entries);
    append_scene_functions(entries);
    return entries;
  }();
  return table;
}

const zonal::shader::FunctionEntry* find_function(std::string_view name) {
  for (const zonal::shader::FunctionEntry& entry : shader_functions()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace zonal_glsl
