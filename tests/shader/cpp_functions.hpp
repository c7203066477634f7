// The functions of zonal/kernels/kernel_list.hpp in C++, in float: what every record and every loop is compared with.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

/// At these numbers of bands: the others differ in nothing but their number, and to compile them all takes a minute.
inline constexpr std::integer_sequence<int, 1, 2, 3, 6> cpp_bands;

/// The outputs (of inouts: what they come to) for these inputs. Throws where the number of bands is not one of them.
std::vector<float> run_in_cpp(std::string_view function, int bands, int order, const std::vector<float>& inputs);
