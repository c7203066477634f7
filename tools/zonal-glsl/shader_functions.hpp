// The functions of zonal/kernels/kernel_list.hpp, compiled once: the program and the tests share them.
#pragma once

#include <string_view>
#include <vector>

#include <zonal/shader/function_table.hpp>

namespace zonal_glsl {

/// All functions, in the order of their table.
const std::vector<zonal::shader::FunctionEntry>& shader_functions();

/// The function of this name, or null.
const zonal::shader::FunctionEntry* find_function(std::string_view name);

}  // namespace zonal_glsl
