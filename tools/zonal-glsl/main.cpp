// zonal-glsl: writes the library's kernels as shader functions.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <zonal/file/output_file.hpp>
#include <zonal/file/standard_output.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/shader/function_table.hpp>

#ifdef ZONAL_GLSL_HAS_JSON
#include "plan_file.hpp"
#endif
#include "request.hpp"

namespace zonal_glsl {
namespace {

constexpr int exit_bad_request = 2;

struct Options {
  Request request;
  std::string bands = std::to_string(std::min(5, zonal::shader::max_bands));
  std::string dialect = "glsl450";
  std::string output, plan;
  bool list = false, count = false, temporaries = false;
};

std::string dialect_names() {
  std::string names;
  for (const auto& dialect : zonal::shader::dialects) names += (names.empty() ? "" : ", ") + std::string(dialect.name);
  return names;
}

void add_options(CLI::App& app, Options& options) {
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
  app.add_option("--bands", options.bands, "Bands, 1 to " + std::to_string(zonal::shader::max_bands))
      ->capture_default_str();
  app.add_option("--dialect", options.dialect, "One of " + dialect_names())->capture_default_str();
  app.add_option("-o,--output", options.output, "The file to write; standard output if none, or -");
  app.add_option("--prefix", options.request.text.prefix, "What all names begin with")->capture_default_str();
  app.add_flag("--precise", options.request.text.precise,
               "Forbid the compiler to reassociate and contract: the bits of C++, for more operations");
  app.add_flag("--flat", options.request.text.flat, "No arrays: a parameter y_4 for each y[4]; some drivers need it");
  app.add_flag("--temporaries", options.temporaries, "A temporary for every operation");
  app.add_flag("--count", options.count, "Print the operations of each function instead");
  app.add_flag("--list", options.list, "Print names and signatures of all functions instead");
}

/// Nothing of a plan's file name but its last part goes into what is written.
void read_plan(Options& options) {
#ifdef ZONAL_GLSL_HAS_JSON
  options.request.plan = zonal_glsl::read_plan(options.plan);
  options.request.plan_name = std::filesystem::path(options.plan).filename().string();
#else
  throw RequestError("--plan: not built in, for want of nlohmann-json");
#endif
}

void run(Options& options) {
  const zonal::shader::Dialect* dialect = zonal::shader::find_dialect(options.dialect);
  if (dialect == nullptr) throw RequestError("--dialect: '" + options.dialect + "' is not one of " + dialect_names());
  options.request.bands = parse_bands("--bands", options.bands);
  if (options.list) {
    std::fputs(function_list(options.request, *dialect).c_str(), stdout);
    return;
  }
  if (!options.plan.empty()) read_plan(options);
  if (options.request.functions.empty() && options.request.adjoints.empty() && !options.request.plan) {
    throw RequestError("--functions names none (--list names them all)");
  }
  if (!options.request.by.empty() && options.request.adjoints.empty()) {
    throw RequestError("--by: there is no --adjoint");
  }
  options.request.text.compound = !options.temporaries;
  const std::string text =
      options.count ? operation_table(options.request, *dialect) : shader_file(options.request, *dialect);
  if (options.output.empty() || options.output == "-") {
    std::fputs(text.c_str(), stdout);
  } else {
    zonal::OutputFile file(options.output);
    file.write(text.data(), text.size());
    file.move_into_place();
  }
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

int parse_and_run(int argc, char** argv) {
  Options options;
  CLI::App app("Writes the kernels of zonal as shader functions.", "zonal-glsl");
  add_options(app, options);
  try {
    app.parse(argc, argv);
    run(options);
    return 0;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  }
}

int run_main(int argc, char** argv) {
  try {
    return zonal::with_standard_output([&] { return parse_and_run(argc, argv); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-glsl: %s\n", first_line(error.what()).c_str());
    return exit_bad_request;
  }
}

}  // namespace
}  // namespace zonal_glsl

int main(int argc, char** argv) { return zonal_glsl::run_main(argc, argv); }
