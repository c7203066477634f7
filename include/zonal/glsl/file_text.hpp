// A whole file of functions: guard, what it was made by and from, functions.
#pragma once

#include <string>
#include <vector>

#include "../version.hpp"
#include "function_text.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace glsl {

/// `guard` names the include guard; `made_by` says what to write in the heading beside the version, such as options.
struct FileHeading {
  std::string guard;
  std::string made_by;
};

inline std::string version_text() {
  return std::to_string(version_major) + "." + std::to_string(version_minor) + "." + std::to_string(version_patch);
}

/// The functions, and texts in the same language that use them, in one file. WGSL has no preprocessor, hence no guard.
inline std::string file_text(const std::vector<RecordedFunction>& functions, const std::vector<std::string>& shells,
                             const Dialect& dialect, const FileHeading& heading, const TextOptions& options = {}) {
  int operations = 0;
  for (const RecordedFunction& function : functions) operations += function.count().total();
  std::string text = "// zonal " + version_text() + ", " + std::string(dialect.title) + ". " + heading.made_by +
                     "\n// " + std::to_string(functions.size()) + " functions, " + std::to_string(operations) +
                     " operations. Written by zonal-glsl: do not edit.\n";
  const bool has_guard = dialect.declarations != Declarations::wgsl;
  if (has_guard) text += "#ifndef " + heading.guard + "\n#define " + heading.guard + "\n\n";
  text += dialect.prologue;
  for (const RecordedFunction& function : functions) text += "\n" + function_text(function, dialect, options);
  for (const std::string& shell : shells) text += "\n" + shell;
  if (has_guard) text += "\n#endif\n";
  return text;
}

}  // namespace glsl
}  // namespace ZONAL_TARGET
}  // namespace zonal
