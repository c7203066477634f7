#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <zonal/shader/dialect.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/shader/function_table.hpp>
#include <zonal/shader/planned_shells.hpp>

namespace zonal_glsl {

/// What the user asks for cannot be had; `what()` is one line for the terminal.
struct RequestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Functions and shells by name: <name>[:even|:degree<l>][@<bands>]. A selection of coefficients, evaluate:even (m >=
/// 0) or evaluate:degree2, leaves the others out, and what they alone need; without @<bands> there are `bands`. Before
/// them what a plan asks for.
struct Request {
  std::vector<std::string> functions;
  std::vector<std::string> adjoints;  // the same, with derivatives; no shells
  std::vector<std::string> by;        // inputs, of all adjoints; if none, all
  int bands = 5;
  std::optional<zonal::shader::PlannedMaterials> plan;
  std::string plan_name;  // for the heading
  zonal::shader::TextOptions text;
};

/// What was asked for, and the functions that its shells need; each once, in the order of first need.
struct Selection {
  std::vector<zonal::shader::RecordedFunction> functions;
  std::vector<zonal::shader::NamedText> shells;
};

/// The number of bands that the text names; RequestError, which names `option`, if it is none.
inline int parse_bands(const std::string& option, const std::string& text) {
  for (int bands = 1; bands <= zonal::shader::max_bands; ++bands) {
    if (text == std::to_string(bands)) return bands;
  }
  throw RequestError(option + ": '" + text + "' is not in 1..." + std::to_string(zonal::shader::max_bands));
}

/// Throws RequestError for a name or a selection that is none.
Selection select(const Request& request, const zonal::shader::Dialect& dialect);

/// The file that holds the selection.
std::string shader_file(const Request& request, const zonal::shader::Dialect& dialect);

/// Names, what they give and their signatures, for --list.
std::string function_list(const Request& request, const zonal::shader::Dialect& dialect);

/// A table of operations, for --count.
std::string operation_table(const Request& request, const zonal::shader::Dialect& dialect);

}  // namespace zonal_glsl
