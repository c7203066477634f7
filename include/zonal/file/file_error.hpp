// What is wrong with a file.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What is wrong with a file: its name, and why, in one line.
class FileError : public std::runtime_error {
 public:
  FileError(const std::filesystem::path& path, const std::string& what)
      : std::runtime_error(path.string() + ": " + what) {}
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
