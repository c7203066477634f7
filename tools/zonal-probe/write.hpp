#pragma once

#include <string>
#include <vector>

#include "conventions.hpp"
#include "options.hpp"

namespace zonal_probe {

/// The coefficients in this format. about: what is worth saying before them, in lines; in JSON as members.
std::string output_text(const Stored& stored, Format format, const std::string& name,
                        const std::vector<std::pair<std::string, std::string>>& about);

}  // namespace zonal_probe
