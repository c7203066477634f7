#include "named_file.hpp"

#include <algorithm>
#include <string>
#include <system_error>

namespace example {

namespace fs = std::filesystem;

std::optional<fs::path> named_file(const fs::path& folder, std::string_view name, bool by_last_part) {
  if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path last = by_last_part ? fs::path(slashed).filename() : fs::path();
  for (const fs::path& path : {fs::path(name), fs::path(slashed), last}) {
    std::error_code error;
    if (!path.empty() && fs::is_regular_file(folder / path, error)) return folder / path;
  }
  return std::nullopt;
}

}  // namespace example
