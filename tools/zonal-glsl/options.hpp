#pragma once

#include <optional>
#include <string>

#include <zonal/shader/dialect.hpp>

#include "request.hpp"

namespace zonal_glsl {

/// The command line. `request` is complete but for its plan, which stands in a file.
struct Options {
  Request request;
  const zonal::shader::Dialect* dialect = nullptr;
  std::string output, plan;
  bool list = false, count = false;
  std::optional<int> exit_status;  // set where --help has said all
};

/// Throws RequestError with one line about what is wrong.
Options parse_command_line(int argc, char** argv);

}  // namespace zonal_glsl
