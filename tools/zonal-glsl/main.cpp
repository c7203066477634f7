// zonal-glsl: writes the library's kernels as shader functions.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include <zonal/file/output_file.hpp>
#include <zonal/file/standard_output.hpp>

#ifdef ZONAL_GLSL_HAS_JSON
#include "plan_file.hpp"
#endif
#include "options.hpp"

namespace zonal_glsl {
namespace {

constexpr int exit_bad_request = 2;

/// Nothing of a plan's file name but its last part goes into what is written.
void read_plan([[maybe_unused]] Options& options) {
#ifdef ZONAL_GLSL_HAS_JSON
  options.request.plan = zonal_glsl::read_plan(options.plan);
  options.request.plan_name = std::filesystem::path(options.plan).filename().string();
#else
  throw RequestError("--plan: not built in, for want of nlohmann-json");
#endif
}

std::string text_of(Options& options) {
  if (options.list) return function_list(options.request, *options.dialect);
  if (!options.plan.empty()) read_plan(options);
  return options.count ? operation_table(options.request, *options.dialect)
                       : shader_file(options.request, *options.dialect);
}

int parse_and_run(int argc, char** argv) {
  Options options = parse_command_line(argc, argv);
  if (options.exit_status) return *options.exit_status;
  const std::string text = text_of(options);
  if (options.list || options.output.empty() || options.output == "-") {
    std::fputs(text.c_str(), stdout);
  } else {
    zonal::OutputFile file(options.output);
    file.write(text.data(), text.size());
    file.move_into_place();
  }
  return 0;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

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
