// zonal-doctor: what somebody's spherical harmonics are, from their values.
//
//   zonal-doctor --directions --bands 3 > directions.txt     directions; evaluate your code's nine functions at each
//   zonal-doctor values.txt                                  and be told what they are, and what is wrong with them
//
// Exit status 0 where nothing is wrong, 1 where something is, 2 for input that is none.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <zonal/convention/diagnose.hpp>
#include <zonal/file/standard_output.hpp>
#include <zonal/version.hpp>

#include "table.hpp"

namespace zonal_doctor {
namespace {

constexpr int exit_wrong = 1, exit_bad_input = 2;

struct Options {
  std::string file, convention, format = "text";
  int bands = 0;
  bool directions = false, list = false;
};

std::string version_text() {
  return "zonal-doctor " + std::to_string(zonal::version_major) + "." + std::to_string(zonal::version_minor) + "." +
         std::to_string(zonal::version_patch);
}

void add_options(CLI::App& app, Options& options) {
  app.set_version_flag("--version", version_text());
  app.add_option("file", options.file,
                 "A line for each direction: x, y, z and N*N values; or the values alone, of the directions that "
                 "--directions prints. - is standard input");
  app.add_option("--bands", options.bands, "Degrees 0 to N-1, 1 to 20; by the number of columns if not given");
  app.add_option("--convention", options.convention, "What it should be, by name: anything else is wrong");
  app.add_option("--format", options.format, "text or json")->capture_default_str();
  app.add_flag("--directions", options.directions, "Print the directions to evaluate at, x y z a line");
  app.add_flag("--list", options.list, "Print the conventions by name");
}

void print_directions(int bands) {
  for (const zonal::Direction& d : zonal::diagnosis_directions(bands))
    std::printf("%.17g %.17g %.17g\n", d[0], d[1], d[2]);
}

void print_conventions() {
  for (const zonal::NamedConvention& named : zonal::kConventions) {
    std::printf("%-24s%s\n%24s%s\n", std::string(named.name).c_str(), std::string(named.what).c_str(), "",
                zonal::describe(named.convention).c_str());
  }
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

template <class Texts>
std::string json_list(const Texts& texts) {
  std::string list = "[";
  for (const auto& text : texts) list += (list.size() > 1 ? ", " : "") + in_quotes(text);
  return list + "]";
}

std::string json(const zonal::Diagnosis& found) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers,
                "  \"bands\": %d,\n  \"scale\": %.9g,\n  \"noise\": %.3g,\n  \"tolerance\": %.3g,\n", found.bands,
                found.scale, found.noise, found.tolerance);
  return std::string("{\n  \"is_right\": ") + (found.is_right ? "true" : "false") + ",\n" + numbers +
         "  \"names\": " + json_list(found.names) + ",\n  \"convention\": " + in_quotes(describe(found.convention)) +
         ",\n  \"faults\": " + json_list(found.faults) + "\n}\n";
}

/// Adds to the faults that it is not what it should be.
void require_convention(zonal::Diagnosis& found, const std::string& name) {
  if (std::find(found.names.begin(), found.names.end(), name) != found.names.end()) return;
  found.faults.insert(found.faults.begin(), "it is not the basis of " + name);
  found.is_right = false;
}

int run(const Options& options) {
  if (options.format != "text" && options.format != "json") {
    throw InputError("--format: '" + options.format + "' is neither text nor json");
  }
  if (!options.convention.empty() && zonal::find_convention(options.convention) == nullptr) {
    throw InputError("--convention: '" + options.convention + "' is none that --list prints");
  }
  if (options.bands != 0 && (options.bands < 1 || options.bands > 20)) {
    throw InputError("--bands: '" + std::to_string(options.bands) + "' is not in 1...20");
  }
  if (options.list) return print_conventions(), 0;
  if (options.directions) {
    if (options.bands == 0) throw InputError("--directions: of how many bands? --bands 3");
    return print_directions(options.bands), 0;
  }
  if (options.file.empty()) throw InputError("name a file of values, or ask for --directions (--help says more)");
  const Table table = parse_table(options.file, read_text(options.file), options.bands);
  zonal::Diagnosis found = zonal::diagnose(table.bands, table.directions, table.values);
  if (!options.convention.empty()) require_convention(found, options.convention);
  std::fputs((options.format == "json" ? json(found) : describe(found)).c_str(), stdout);
  return found.is_right ? 0 : exit_wrong;
}

int parse_and_run(int argc, char** argv) {
  Options options;
  CLI::App app("Says what somebody's spherical harmonics are, from their values.", "zonal-doctor");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  }
  return run(options);
}

int run_main(int argc, char** argv) {
  try {
    return zonal::with_standard_output([&] { return parse_and_run(argc, argv); });
  } catch (const std::exception& error) {
    const std::string text = error.what();
    std::fprintf(stderr, "zonal-doctor: %s\n", text.substr(0, text.find('\n')).c_str());
    return exit_bad_input;
  }
}

}  // namespace
}  // namespace zonal_doctor

int main(int argc, char** argv) { return zonal_doctor::run_main(argc, argv); }
