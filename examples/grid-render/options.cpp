#include "options.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "band_list.hpp"
#include "option_names.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace example::grid_render {
namespace {

void add_output_options(CLI::App& app, Options& options) {
  CLI::Option* compare =
      add_compare_option(app, options,
                         "Render without a grid, by each interpolation, and trilinearly in the memory of the others; "
                         "write the pictures and their differences there; excludes --interpolation and --out");
  app.add_option_function<std::string>(
         "--compare-shapes",
         [&options](const std::string& directory) {
           options.compare_directory = directory;
           options.comparing_shapes = true;
         },
         "Render the lights as spheres, zonal by zonal, as triangles and as triangle-spheres, without a grid and by "
         "hermite; write the pictures and their differences there")
      ->type_name("DIRECTORY")
      ->check(not_empty())
      ->group(run_group)
      ->excludes(compare);
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
  add_choice(app, "--shape", shape_names, options.shape,
             "What a lantern or texel is: a sphere, a square of the same area as two triangles, or these as spheres "
             "with a cosine")
      ->group(group);
  add_number(app, "--texture-size", options.texture_size, 1, 512, "1...512", "Texels on the longer side")
      ->group(group)
      ->needs(texture);
  add_number_function(
      app, "--quadtree-error", [&options](float bound) { options.quadtree_error = bound; }, 0.0f, 1000.0f, "0...1000",
      "One light for a block of texels that differ from its mean by at most so much of the picture's mean")
      ->group(group)
      ->needs(texture);
}

void add_grid_options(CLI::App& app, Options& options) {
  const std::string group = "Grid";
  add_resolution_option(app, options.grid, 32, "Vertices along each axis of the scene's box")->group(group);
  add_one_of(app, "--bands", options.bands, lighting_bands(Shape::spheres),
             "Bands of the light; of triangles " + joined(lighting_bands(Shape::triangles)))
      ->group(group);
  add_number(app, "--lobe-bands", options.lobe_bands, 1, most_lobe_bands, "1..." + std::to_string(most_lobe_bands),
             "Bands of the glossy lobes; those beyond the light's meet nothing")
      ->group(group);
  app.add_option("--save-grid", options.save_grid, "Write the grid there as well, with its gradients")
      ->type_name("FILE")
      ->check(not_empty())
      ->group(group);
  app.add_option("--load-grid", options.load_grid,
                 "Light the scene by the grid that --save-grid wrote of it, of as many bands, instead of lights")
      ->type_name("FILE")
      ->check(not_empty())
      ->group(group);
  CLI::Option* paths = add_number(
      app, "--paths", options.paths, 1, 65536, "1...65536",
      "Light by so many paths at each vertex, and point seen of the reference: lights cast shadows, and "
      "surfaces light each other. The grid has no gradients, is trilinear, and its vertices are moved out of "
      "walls");
  paths->group(group);
  app.add_flag("--visibility", options.is_visible,
               "Weigh vertices by what each point sees of them, against light that leaks "
               "through walls; --compare does so beside plain weights")
      ->group(group)
      ->needs(paths);
  add_choice(app, "--window", window_names, options.window, "What tames the ringing of the glossy lobes")->group(group);
}

void add_plan_options(CLI::App& app, Options& options) {
  const std::string group = "Tolerance";
  CLI::Option* tolerance = add_number(
      app, "--tolerance", options.tolerance, 0.0, 1.0, "0...1",
      "How far the light may be off that of all lights at each point, as a root mean square: 0.01 is 1 %. "
      "Vertices, bands and interpolation of the grid are then chosen, and which lights are too near for it; 0 "
      "takes what the other options say");
  tolerance->group(group);
  app.add_flag("--explain", options.explain, "Report what was chosen, why, and what it saved")
      ->group(group)
      ->needs(tolerance);
}

/// What does not go together, beside what each option has said already.
void add_exclusions(CLI::App& app) {
  const auto exclude = [&](const std::string& name, const std::vector<std::string>& others) {
    for (const std::string& other : others) app.get_option(name)->excludes(app.get_option(other));
  };
  exclude("--compare-shapes", {"--interpolation", "--out", "--shape", "--save-grid", "--load-grid"});
  exclude("--compare", {"--save-grid", "--load-grid"});
  exclude("--load-grid", {"--save-grid", "--grid", "--lights", "--texture", "--shape"});
  exclude("--tolerance", {"--interpolation", "--compare", "--compare-shapes", "--shape", "--grid", "--paths",
                          "--save-grid", "--load-grid"});
  exclude("--paths", {"--interpolation", "--compare-shapes", "--shape", "--save-grid", "--load-grid"});
}

void check(const Options& options) {
  const bool has_triangles = options.comparing_shapes || options.shape != Shape::spheres;
  const std::vector<int> bands = lighting_bands(has_triangles ? Shape::triangles : Shape::spheres);
  if (std::find(bands.begin(), bands.end(), options.bands) == bands.end()) {
    throw InputError("--bands: '" + std::to_string(options.bands) + "' is not one of " + joined(bands) +
                     ", as triangles need");
  }
  for (const auto& [name, file] : {std::pair("--save-grid", options.save_grid), {"--load-grid", options.load_grid}}) {
    if (!file.empty() && !options.method) throw InputError(std::string(name) + ": --interpolation none has no grid");
  }
}

}  // namespace

std::vector<int> lighting_bands(Shape shape) {
  const auto list = [](const auto& numbers) { return std::vector<int>(std::begin(numbers), std::end(numbers)); };
  return shape == Shape::spheres ? list(AllBands::numbers) : list(TriangleBands::numbers);
}

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders a scene lit by many sphere or triangle lights: their spherical\n"
      "harmonics and the gradients, computed at the vertices of a 3D grid and\n"
      "interpolated between. No light casts a shadow, unless by --paths.",
      "grid-render");
  set_up(app);
  add_output_options(app, line.options);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_image_options(app, line.options);
  add_light_options(app, line.options);
  add_grid_options(app, line.options);
  add_plan_options(app, line.options);
  add_exclusions(app);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status) check(line.options);
  return line;
}

}  // namespace example::grid_render
