#include "options.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/shader/function_table.hpp>

namespace zonal_glsl {
namespace {

/// What is checked only when all has been read.
struct Texts {
  std::string bands = std::to_string(std::min(5, zonal::shader::max_bands));
  std::string dialect = "glsl450";
  bool temporaries = false;
};

std::string dialect_names() {
  std::string names;
  for (const auto& dialect : zonal::shader::dialects) names += (names.empty() ? "" : ", ") + std::string(dialect.name);
  return names;
}

void add_options(CLI::App& app, Options& options, Texts& texts) {
  app.set_version_flag("--version", "zonal-glsl " + zonal::shader::version_text());
  app.add_option("--functions", options.request.functions,
                 "What to write, by name; with a number of bands of its own: evaluate@3; of evaluate and its like also "
                 "a part: evaluate:even, evaluate:degree2@4")
      ->delimiter(',');
  app.add_option(
         "--adjoint", options.request.adjoints,
         "The same, each with derivatives: takes a loss's by its outputs, by_value, and gives those by its inputs")
      ->delimiter(',');
  app.add_option("--by", options.request.by, "The inputs that --adjoint is for, by name; otherwise all: sh,direction")
      ->delimiter(',');
  app.add_option("--plan", options.plan,
                 "A plan, or a report that has one, in JSON: writes what it keeps, and zonal_gather_planned");
  app.add_option("--bands", texts.bands, "Bands, 1 to " + std::to_string(zonal::shader::max_bands))
      ->capture_default_str();
  app.add_option("--dialect", texts.dialect, "One of " + dialect_names())->capture_default_str();
  app.add_option("-o,--output", options.output, "The file to write; standard output if none, or -");
  app.add_option("--prefix", options.request.text.prefix, "What all names begin with")->capture_default_str();
  app.add_flag("--precise", options.request.text.precise,
               "Forbid the compiler to reassociate and contract: the bits of C++, for more operations");
  app.add_flag("--flat", options.request.text.flat, "No arrays: a parameter y_4 for each y[4]; some drivers need it");
  app.add_flag("--temporaries", texts.temporaries, "A temporary for every operation");
  app.add_flag("--count", options.count, "Print the operations of each function instead");
  app.add_flag("--list", options.list, "Print names and signatures of all functions instead");
}

void check(Options& options, const Texts& texts) {
  options.dialect = zonal::shader::find_dialect(texts.dialect);
  if (options.dialect == nullptr) {
    throw RequestError("--dialect: '" + texts.dialect + "' is not one of " + dialect_names());
  }
  options.request.bands = parse_bands("--bands", texts.bands);
  options.request.text.compound = !texts.temporaries;
  if (options.list) return;
  if (options.request.functions.empty() && options.request.adjoints.empty() && options.plan.empty()) {
    throw RequestError("--functions names none (--list names them all)");
  }
  if (!options.request.by.empty() && options.request.adjoints.empty()) {
    throw RequestError("--by: there is no --adjoint");
  }
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

Options parse_command_line(int argc, char** argv) {
  Options options;
  Texts texts;
  CLI::App app("Writes the kernels of zonal as shader functions.", "zonal-glsl");
  add_options(app, options, texts);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    options.exit_status = app.exit(success);
    return options;
  } catch (const CLI::ParseError& error) {
    throw RequestError(first_line(error.what()));
  }
  check(options, texts);
  return options;
}

}  // namespace zonal_glsl
