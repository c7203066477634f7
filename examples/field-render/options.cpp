#include "options.hpp"

#include "option_names.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace example::field_render {
namespace {

void add_output_options(CLI::App& app, Options& options) {
  CLI::Option* compare = add_compare_option(
      app, options,
      "Render by the grid and by --reference, and write both pictures and their difference (red: the grid is brighter) "
      "there; excludes --out");
  add_out_option(app, options)->excludes(compare);
  add_run_options(app, options);
}

void add_field_options(CLI::App& app, Options& options) {
  const std::string group = "Light and things";
  app.add_option("--grid", options.grid, "The coefficient grid that lights what is in its box")
      ->type_name("FILE")
      ->check(not_empty())
      ->required()
      ->group(group);
  app.add_option("--object", options.object,
                 "What stands in the box: a table, figures on it, or what an OBJ file holds")
      ->type_name("table|figures|FILE.obj")
      ->check(not_empty())
      ->capture_default_str()
      ->group(group);
  add_material_option(app, options.materials)->group(group);
  add_choice(app, "--interpolation", interpolation_names, options.interpolation,
             "Between vertices; hermite where the grid has gradients")
      ->group(group);
  add_number(app, "--bands", options.bands, 1, 6, "1...6",
             "Bands of glossy surfaces, as far as the grid has them; matte ones have three")
      ->group(group);
  add_choice(app, "--window", window_names, options.window, "What tames the ringing of gloss")->group(group);
}

void add_reference_options(CLI::App& app, Options& options) {
  const std::string group = "Reference";
  app.add_option_function<std::string>(
         "--reference",
         [&options](const std::string& name) {
           for (const auto& [word, setup] : field_setup_names) {
             if (word == name) options.reference = setup;
           }
         },
         "Without --compare instead of the grid: paths from what stands in the box to the scene in this set-up of "
         "field-capture; things light and shadow nothing")
      ->type_name("projector|spots")
      ->check(validator([](const std::string& name) -> std::string {
        for (const auto& [word, setup] : field_setup_names) {
          if (word == name) return {};
        }
        return "'" + name + "' is not one of projector|spots";
      }))
      ->group(group);
  add_box_option(app, options.box, field_box_help)->group(group);
  add_number(app, "--samples", options.samples, 1, 65536, "1...65536", "Paths in each pixel")->group(group);
  add_number(app, "--bounces", options.bounces, 0, 16, "0...16", "Between surfaces of the scene")->group(group);
  add_number(app, "--seed", options.seed, std::uint64_t{0}, ~std::uint64_t{0}, "0...2^64-1",
             "Another seed, another noise")
      ->group(group);
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders things that stand in an incident light field, a coefficient grid as\n"
      "field-bake makes it, and compares with the light that is truly there.",
      "field-render");
  set_up(app);
  add_output_options(app, line.options);
  add_scene_options(app, line.options);
  add_image_options(app, line.options);
  add_field_options(app, line.options);
  add_reference_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status && line.options.comparing() && !line.options.reference) {
    throw InputError("--compare needs --reference");
  }
  return line;
}

}  // namespace example::field_render
