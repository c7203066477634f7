#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace example {

/// The file of a folder that an OBJ or MTL file names: as named, in quotes, with the other system's separators, or even
/// by its last part alone, where that is a file.
std::optional<std::filesystem::path> named_file(const std::filesystem::path& folder, std::string_view name,
                                                bool by_last_part = false);

}  // namespace example
