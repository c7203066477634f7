#pragma once

#include <string>

namespace example {

/// Looks for what tinyobjloader reads as if it were in order: vertices that are not three finite numbers of a
/// sensible size. Returns the name of the first material file, if any. Throws InputError.
std::string check_obj(const std::string& path);

}  // namespace example
