#include "options.hpp"

#include "option_names.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace example::field_capture {
namespace {

void add_place_options(CLI::App& app, Options& options) {
  const std::string group = "Light and probes";
  add_choice(app, "--setup", field_setup_names, options.setup,
             "An area light and a projector of coloured squares; or a half-blocked red spotlight and a cone of white "
             "light")
      ->group(group);
  add_box_option(app, options.box, field_box_help)->group(group);
  add_number(app, "--probes", options.probes, 1, 1000000, "1...1000000", "How many, about: what the layout can have")
      ->group(group);
  add_choice(app, "--layout", layout_names, options.layout,
             "A regular grid, three planes through the middle, or one in each cell of a grid at random")
      ->group(group);
}

void add_picture_options(CLI::App& app, Options& options) {
  const std::string group = "Pictures";
  add_number(app, "--size", options.side, 8, 4096, "8...4096", "Height in texels; faces of cubes have half as many")
      ->group(group);
  add_choice(app, "--mapping", mapping_names(), options.mapping, "Which texel is which direction")->group(group);
  add_number_function(
      app, "--sphere-radius", [&options](float radius) { options.sphere_radius = radius; }, 0.0f, 1.0f, "0...1 metres",
      "Of the mirror sphere, whose surface rays start on; 0 is one viewpoint, as of all other mappings. Without it "
      "0.05")
      ->group(group);
  add_number(app, "--dead-angle", options.dead_angle, 0.0f, 90.0f, "0...90 degrees",
             "About what is right behind a mirror sphere, which does not show it")
      ->group(group);
  add_choice(app, "--dead-angle-is", dead_angle_names, options.dead_angle_is,
             "What the sequence says of it; the texels are black")
      ->group(group);
}

void add_path_options(CLI::App& app, Options& options) {
  const std::string group = "Paths";
  add_number(app, "--samples", options.samples, 1, 65536, "1...65536", "Paths in each texel")->group(group);
  add_number(app, "--bounces", options.bounces, 0, 16, "0...16", "Between surfaces")->group(group);
  add_number(app, "--seed", options.seed, std::uint64_t{0}, ~std::uint64_t{0}, "0...2^64-1",
             "Another seed, another noise, and other places at random")
      ->group(group);
}

void add_truth_options(CLI::App& app, Options& options) {
  const std::string group = "Truth";
  CLI::Option* truth = app.add_option("--truth", options.truth,
                                      "Instead of pictures: the coefficients of what arrives at the positions in this "
                                      "file, x y z a line, from one viewpoint, as CSV to --out")
                           ->type_name("FILE")
                           ->check(not_empty())
                           ->group(group);
  add_number(app, "--bands", options.bands, 1, 9, "1...9", "Bands of the coefficients")->needs(truth)->group(group);
  add_number(app, "--truth-samples", options.truth_samples, 16, 1 << 24, "16...16777216", "Paths from each position")
      ->needs(truth)
      ->group(group);
  for (const char* name : {"--probes", "--layout", "--size", "--mapping", "--sphere-radius", "--dead-angle",
                           "--dead-angle-is", "--samples"}) {
    truth->excludes(app.get_option(name));
  }
}

void check(Options& options, const CLI::App& app) {
  const bool is_mirror = options.is_mirror();
  if (!is_mirror && options.sphere_radius.value_or(0.0f) > 0.0f) {
    throw InputError("--sphere-radius: only of --mapping mirror-sphere");
  }
  if (!is_mirror && app.count("--dead-angle") > 0 && options.dead_angle > 0.0f) {
    throw InputError("--dead-angle: only of --mapping mirror-sphere");
  }
  if (!is_mirror) options.dead_angle = 0.0f;
  if (!options.sphere_radius) options.sphere_radius = is_mirror ? 0.05f : 0.0f;
  if (!options.truth.empty() && app.count("--out") == 0) options.out = "truth.csv";
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Captures a sequence of light probes in a scene by path tracing: pictures of\n"
      "all directions, and sequence.txt, which says where each was taken. Stopped,\n"
      "it leaves those that are done; run again, it goes on.",
      "field-capture");
  set_up(app);
  app.add_option("--out", line.options.out,
                 "The folder of pictures and sequence.txt; of --truth the CSV file, without it truth.csv")
      ->type_name("DIRECTORY|FILE.csv")
      ->check(not_empty())
      ->capture_default_str()
      ->group(run_group);
  add_thread_options(app, line.options);
  add_scene_choice(app, line.options);
  add_place_options(app, line.options);
  add_picture_options(app, line.options);
  add_path_options(app, line.options);
  add_truth_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status) check(line.options, app);
  return line;
}

}  // namespace example::field_capture
