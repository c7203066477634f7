// The functions of zonal/glsl/functions.hpp in C++, in float: what every shader is compared with.
#pragma once

#include <string_view>
#include <vector>

/// The outputs (of inouts: what they come to) for these inputs.
std::vector<float> run_in_cpp(std::string_view function, int bands, int order, const std::vector<float>& inputs);
