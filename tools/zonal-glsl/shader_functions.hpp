// The functions of zonal/glsl/functions.hpp, compiled once: the program and the tests share them.
#pragma once

#include <string_view>
#include <vector>

#include <zonal/glsl/function_table.hpp>

namespace zonal_glsl {

/// All functions, in the order of their table.
const std::vector<zonal::glsl::FunctionEntry>& shader_functions();

/// The function of this name, or null.
const zonal::glsl::FunctionEntry* find_function(std::string_view name);

}  // namespace zonal_glsl
