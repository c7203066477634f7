#pragma once

#include <string>
#include <vector>

#include <zonal/environment/mapping.hpp>

namespace zonal_probe {

/// What --mapping takes: auto, equirectangular, vertical-cross, ...
std::vector<std::string> mapping_words();
std::string mapping_word(zonal::Mapping mapping);

}  // namespace zonal_probe
