#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <zonal/glsl/dialect.hpp>
#include <zonal/glsl/function_text.hpp>

namespace zonal_glsl {

/// What the user asks for cannot be had; `what()` is one line for the terminal.
struct RequestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Functions and shells by name, for one number of bands. A function's name may end in a selection of its coefficients,
/// evaluate:even (m >= 0) or evaluate:degree2: what the others alone need is left out.
struct Request {
  std::vector<std::string> functions;
  int bands = 5;
  zonal::glsl::TextOptions text;
};

/// What was asked for, and the functions that its shells need; each once, in the order of first need.
struct Selection {
  std::vector<zonal::glsl::RecordedFunction> functions;
  std::vector<std::string> shells;
};

/// Throws RequestError for a name or a selection that is none.
Selection select(const Request& request, const zonal::glsl::Dialect& dialect);

/// The file that holds the selection.
std::string shader_file(const Request& request, const zonal::glsl::Dialect& dialect);

/// Names and what they give, for --list.
std::string function_list();

/// A table of operations, for --count.
std::string operation_table(const Request& request, const zonal::glsl::Dialect& dialect);

}  // namespace zonal_glsl
