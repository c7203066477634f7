// A whole file of functions: what it was made by, and the functions, each behind a guard of its own.
//
// Two files may have functions in common and be included, or pasted, into one: the first text of a function counts.
// WGSL has no preprocessor, hence no guards: there all functions come in one file, or each file has a prefix of its
// own.
#pragma once

#include <cctype>
#include <string>
#include <vector>

#include "../version.hpp"
#include "function_text.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

inline std::string version_text() {
  return std::to_string(version_major) + "." + std::to_string(version_minor) + "." + std::to_string(version_patch);
}

inline std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// The text of what has this name, once: ZONAL_EVALUATE_5 guards zonal_evaluate_5.
inline std::string guarded(const std::string& name, const std::string& text, const Dialect& dialect) {
  if (!dialect.has_preprocessor) return text;
  const std::string guard = upper_case(name);
  return "#ifndef " + guard + "\n#define " + guard + "\n" + text + "#endif\n";
}

/// A text in the same language that uses the functions.
struct NamedText {
  std::string name, text;
};

/// `made_by` says what to write in the heading beside the version, such as options.
inline std::string file_text(const std::vector<RecordedFunction>& functions, const std::vector<NamedText>& shells,
                             const Dialect& dialect, const std::string& made_by, const TextOptions& options = {}) {
  int operations = 0;
  for (const RecordedFunction& function : functions) operations += function.count().total();
  std::string text = "// zonal " + version_text() + ", " + std::string(dialect.title) + ". " + made_by + "\n// " +
                     std::to_string(functions.size()) + (functions.size() == 1 ? " function, " : " functions, ") +
                     std::to_string(operations) + " operations. Written by zonal-glsl: do not edit.\n";
  text += dialect.prologue;
  for (const RecordedFunction& function : functions) {
    text += "\n" + guarded(text_name(function, options), function_text(function, dialect, options), dialect);
  }
  for (const NamedText& shell : shells) text += "\n" + guarded(shell.name, shell.text, dialect);
  return text;
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
