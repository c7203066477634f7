#include "input_error.hpp"

#include <algorithm>
#include <system_error>

namespace example {

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError(path.string() + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path.string() + ": is not a file");
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace example
