#include "shader_functions.hpp"

namespace zonal_glsl {

// Each compiled apart: they take a while.
void append_basis_functions(std::vector<zonal::glsl::FunctionEntry>& entries);
void append_scene_functions(std::vector<zonal::glsl::FunctionEntry>& entries);

const std::vector<zonal::glsl::FunctionEntry>& shader_functions() {
  static const std::vector<zonal::glsl::FunctionEntry> table = [] {
    std::vector<zonal::glsl::FunctionEntry> entries;
    append_basis_functions(entries);
    append_scene_functions(entries);
    return entries;
  }();
  return table;
}

const zonal::glsl::FunctionEntry* find_function(std::string_view name) {
  for (const zonal::glsl::FunctionEntry& entry : shader_functions()) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

}  // namespace zonal_glsl
