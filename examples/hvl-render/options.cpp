#include "options.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "gather_hvl.hpp"
#include "option_names.hpp"
#include "shared/command_line.hpp"

namespace example::hvl_render {
namespace {

CLI::Validator radius_rule() {
  return validator([](const std::string& text) -> std::string {
    float metres = 0.0f;
    const bool number = parse_number(text, metres) && metres > 0.0f && std::isfinite(metres);
    if (text == "r1" || text == "r2" || number) return {};
    return "'" + text + "' is neither r1 nor r2 nor a positive number of metres";
  });
}

void add_output_options(CLI::App& app, Options& options) {
  CLI::Option* compare =
      add_compare_option(app, options,
                         "Render by both methods, and write hvl, reference and difference (red: hvl is brighter) "
                         "there; excludes --method, --out and --reference");
  add_choice(app, "--method", method_names, options.method, "Virtual lights, or Monte Carlo paths")
      ->group(run_group)
      ->excludes(compare);
  add_out_option(app, options)->excludes(compare);
  app.add_option("--reference", options.reference, "Compare the picture with this one of the same size")
      ->type_name("FILE.exr")
      ->check(not_empty())
      ->group(run_group)
      ->excludes(compare);
}

void add_light_options(CLI::App& app, LightOverrides& light) {
  add_point(app, "--light", light.position, "Where the spotlight is")->group(scene_group);
  add_point(app, "--light-target", light.target, "What it points at")->group(scene_group);
  add_angle(app, "--light-angle", 178.0f, 0.5f, light.half_angle, "Full angle of its cone")->group(scene_group);
  app.add_option_function<float>(
         "--light-power", [&light](const float& watts) { light.power = watts; },
         "What it sends into the cone, per colour channel; makes it white")
      ->type_name("WATTS")
      ->check(between(1e-6f, 1e12f, "1e-6...1e12 watts"))
      ->group(scene_group);
}

void set_radius(const std::string& radius, Options& options) {
  if (radius == "r1") {
    options.radius = RadiusRule::neighbours;
  } else if (radius == "r2") {
    options.radius = RadiusRule::field_of_view;
  } else {
    options.radius = RadiusRule::fixed;
    parse_number(radius, options.fixed_radius);
  }
}

void add_hvl_options(CLI::App& app, Options& options) {
  const std::string group = "Harmonics virtual lights";
  add_number(app, "--lights", options.lights, 1, 1000000, "1...1000000", "How many; rounded up to a square")
      ->group(group);
  add_one_of(app, "--bands", options.bands, gather_bands(), "Bands of the receiver's material")->group(group);
  add_one_of(app, "--emission-bands", options.emission_bands, emission_bands(),
             "Bands of the light that a virtual light sends out")
      ->group(group);
  app.add_option_function<std::string>(
         "--radius", [&options](const std::string& radius) { set_radius(radius, options); },
         "By the distances to neighbours (r1), by the cone's angle (r2), or the same for all")
      ->type_name("r1|r2|METRES")
      ->check(radius_rule())
      ->default_str("r2")
      ->group(group);
  add_number(app, "--radius-factor", options.radius_factor, 0.01f, 100.0f, "0.01...100", "Multiplies r1 and r2")
      ->group(group);
  add_choice(app, "--horizon", horizon_names, options.horizon, "How the receiver's horizon cuts a light")->group(group);
  add_choice(app, "--window", window_names, options.window, "What tames the ringing of the materials")->group(group);
}

void add_path_options(CLI::App& app, Options& options) {
  const std::string group = "Path tracing";
  add_number(app, "--spp", options.samples_per_pixel, 1, 1000000, "1...1000000",
             "Paths per pixel; rounded up to as many at each antialiasing position")
      ->group(group);
  add_number(app, "--bounces", options.bounces, 1, 64, "1...64", "Indirect bounces; virtual lights always have one")
      ->group(group);
  add_number(app, "--seed", options.seed, std::uint64_t{0}, ~std::uint64_t{0}, "0...2^64-1",
             "Another seed, another noise")
      ->group(group);
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders a scene lit by one spotlight: direct light, and one bounce by Harmonics\n"
      "Virtual Lights or by paths.",
      "hvl-render");
  set_up(app);
  add_output_options(app, line.options);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_light_options(app, line.options.light);
  add_image_options(app, line.options);
  add_hvl_options(app, line.options);
  add_path_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  return line;
}

}  // namespace example::hvl_render
