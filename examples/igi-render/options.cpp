#include "options.hpp"

#include <array>

#include "option_names.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace example::igi_render {
namespace {

const std::vector<int> shaded_bands{2, 3, 4, 5};  // with_bands has a case for each

bool parse_pattern(const std::string& text, zonal::InterleavedPattern& pattern) {
  std::array<int, 2> sides{};
  if (!parse_numbers(text, 'x', sides)) return false;
  pattern = {sides[0], sides[1]};
  return true;
}

CLI::Validator pattern_size() {
  return validator([](const std::string& text) -> std::string {
    zonal::InterleavedPattern pattern;
    constexpr int most = zonal::InterleavedPattern::longest_side;
    if (parse_pattern(text, pattern) && pattern.what_is_wrong(most, most).empty()) return {};
    return "'" + text + "' is not a pattern such as 4x4, 1x1 to 16x16";
  });
}

void add_filter_options(CLI::App& app, Options& options) {
  const std::string group = "Interleaved sampling and filter";
  app.add_option_function<std::string>(
         "--pattern", [&options](const std::string& text) { parse_pattern(text, options.pattern); },
         "N x M sets of lights; a pixel sees one of them")
      ->type_name("NxM")
      ->check(pattern_size())
      ->default_str("4x4")
      ->group(group);
  add_one_of(app, "--bands", options.bands, shaded_bands, "Bands of the incident radiance")->group(group);
  add_choice(app, "--window", window_names, options.window, "What tames the ringing of these bands on what is glossy")
      ->group(group);
  app.add_flag("--half", options.half, "Keep what is filtered in 16 bits")->group(group);
  add_number(app, "--normal-angle-cosine", options.tests.cos_normal, -1.0f, 1.0f, "-1...1",
             "Least cosine between the geometric normals of one surface; -1 lets all pass")
      ->group(group);
  add_number(app, "--plane-distance", options.tests.plane_distance, 0.0f, 1.0f, "0...1",
             "How far one surface may leave its tangent plane, of the distance to the eye")
      ->group(group);
}

void add_light_options(CLI::App& app, Options& options) {
  const std::string group = "Lights";
  CLI::Option* lighting = add_choice(app, "--lighting", lighting_names, options.lighting,
                                     "The scene's spotlight, three coloured points, the scene's panel, or --probe")
                              ->group(group);
  app.add_option_function<std::string>(
         "--probe",
         [&options](const std::string& path) {
           options.probe = path;
           options.lighting = Lighting::probe;
         },
         "A picture of the surroundings that lights the scene; its shape says what it is: equirectangular, a cross or "
         "row of cube faces, an angular map or octahedral")
      ->type_name("FILE")
      ->check(not_empty())
      ->excludes(lighting)
      ->group(group);
  add_number(app, "--sets", options.samples, 1, 4096, "1...4096",
             "Samples in each set: of the panel or probe, and paths of indirect light")
      ->group(group);
  add_number(app, "--bounces", options.bounces, 0, 16, "0...16", "Of indirect light, each a light of its own")
      ->group(group);
  add_number(app, "--least-distance", options.least_distance, 0.0f, 1e6f, "0...1e6 metres",
             "A light that is nearer counts as standing there; 0 is a fiftieth of the scene's radius")
      ->group(group);
  add_number(app, "--seed", options.seed, std::uint64_t{0}, ~std::uint64_t{0}, "0...2^64-1",
             "Another seed, other samples")
      ->group(group);
}

void check(const Options& options) {
  if (options.lighting == Lighting::probe && options.probe.empty()) throw InputError("--lighting probe needs --probe");
  const std::string wrong =
      options.pattern.what_is_wrong(options.width * options.antialias, options.height * options.antialias);
  if (!wrong.empty()) throw InputError("--pattern: " + wrong);
  constexpr double most_positions = 3.2e7;
  const double positions = double(options.width) * options.height * options.antialias * options.antialias;
  if (positions > most_positions) throw InputError("--size and --antialias ask for more than 32 million positions");
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders a scene by instant radiosity: every pixel sees one of N x M sets of\n"
      "lights, and a filter gives it the mean of all of them.",
      "igi-render");
  set_up(app);
  CLI::Option* compare =
      add_compare_option(app, line.options,
                         "Render by every filter, and by all sets at every pixel, and write the pictures and their "
                         "differences from the latter (red: brighter) there; excludes --out and --filter");
  add_choice(app, "--filter", filter_names, line.options.filter,
             "What is averaged: incident radiance, reflected light (by geometry, or by shading normals too), six "
             "floats of radiance read as a spherical Gaussian or as L1, or nothing")
      ->excludes(compare)
      ->group(run_group);
  add_out_option(app, line.options)->excludes(compare);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_image_options(app, line.options);
  add_filter_options(app, line.options);
  add_light_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status) check(line.options);
  return line;
}

}  // namespace example::igi_render
