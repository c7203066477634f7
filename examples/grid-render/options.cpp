#include "options.hpp"

#include <algorithm>
#include <array>

#include "lighting.hpp"
#include "option_names.hpp"
#include "shared/command_line.hpp"

namespace example::grid_render {
namespace {

/// 8, or 8x8x8.
bool parse_resolution(const std::string& text, std::array<int, 3>& resolution) {
  int all = 0;
  if (parse_number(text, all)) {
    resolution.fill(all);
    return true;
  }
  return parse_numbers(text, 'x', resolution);
}

CLI::Validator grid_resolution() {
  return validator([](const std::string& text) -> std::string {
    std::array<int, 3> resolution{};
    const auto possible = [](int vertices) { return vertices >= 2 && vertices <= 32; };
    const bool good = parse_resolution(text, resolution) && std::all_of(resolution.begin(), resolution.end(), possible);
    return good ? "" : "'" + text + "' is not a resolution such as 8 or 8x8x8, each number 2 to 32";
  });
}

void add_output_options(CLI::App& app, Options& options) {
  CLI::Option* compare =
      add_compare_option(app, options,
                         "Render without a grid, by each interpolation, and trilinearly in the memory of the others; "
                         "write the pictures and their differences there; excludes --interpolation and --out");
  add_choice(app, "--interpolation", method_names, options.method,
             "Between the grid's vertices; none projects each light at each point seen")
      ->group(run_group)
      ->excludes(compare);
  add_out_option(app, options)->excludes(compare);
}

void add_light_options(CLI::App& app, Options& options) {
  const std::string group = "Lights";
  CLI::Option* texture =
      app.add_option("--texture", options.texture,
                     "A picture (EXR, HDR, PNG, JPEG) that shines: stretched over a rectangle, a sphere light for "
                     "each of its texels")
          ->type_name("FILE")
          ->check(not_empty())
          ->group(group);
  add_number(app, "--lights", options.lights, 1, 100000, "1...100000", "How many lanterns; excludes --texture")
      ->group(group)
      ->excludes(texture);
  add_number(app, "--texture-size", options.texture_size, 1, 512, "1...512", "Texels on the longer side")
      ->group(group)
      ->needs(texture);
  const std::string range = "0...1000";
  app.add_option_function<float>(
         "--quadtree-error", [&options](const float& bound) { options.quadtree_error = bound; },
         "One light for a block of texels that differ from its mean by at most so much of the picture's mean")
      ->type_name(range)
      ->check(between(0.0f, 1000.0f, range))
      ->group(group)
      ->needs(texture);
}

void add_grid_options(CLI::App& app, Options& options) {
  const std::string group = "Grid";
  const auto set_resolution = [&options](const std::string& text) {
    std::array<int, 3> resolution{};
    parse_resolution(text, resolution);
    options.grid = {resolution[0], resolution[1], resolution[2]};
  };
  app.add_option_function<std::string>("--grid", set_resolution, "Vertices along each axis of the scene's box")
      ->type_name("N|XxYxZ")
      ->check(grid_resolution())
      ->default_str("8")
      ->group(group);
  add_one_of(app, "--bands", options.bands, lighting_bands(), "Bands of the light")->group(group);
  add_number(app, "--lobe-bands", options.lobe_bands, 1, most_lobe_bands, "1..." + std::to_string(most_lobe_bands),
             "Bands of the glossy lobes; those beyond the light's meet nothing")
      ->group(group);
  add_choice(app, "--window", window_names, options.window, "What tames the ringing of the glossy lobes")->group(group);
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders a scene lit by many sphere lights: their spherical harmonics and the\n"
      "gradients, computed at the vertices of a 3D grid and interpolated between. No\n"
      "light casts a shadow.",
      "grid-render");
  set_up(app);
  add_output_options(app, line.options);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_image_options(app, line.options);
  add_light_options(app, line.options);
  add_grid_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  return line;
}

}  // namespace example::grid_render
