#include "options.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bands.hpp"
#include "option_names.hpp"
#include "shared/command_line.hpp"
#include "shared/input_error.hpp"

namespace example::hvl_render {
namespace {

template <std::size_t Size>
std::vector<int> listed(const std::array<int, Size>& numbers) {
  return {numbers.begin(), numbers.end()};
}
std::vector<int> gather_bands() { return listed(compiled_bands); }
std::vector<int> zonal_bands() { return listed(compiled_zonal_bands); }

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
                         "Render by --method and by paths, and write both pictures, named by method and reference, and "
                         "their difference (red: the method is brighter) there; excludes --out and --reference");
  add_choice(app, "--method", method_names, options.method,
             "Virtual lights: points, spheres by sampling, spherical Gaussians, harmonics, zonal harmonics; or Monte "
             "Carlo paths")
      ->group(run_group);
  add_out_option(app, options)->excludes(compare);
  app.add_option("--reference", options.reference, "Compare the picture with this one of the same size")
      ->type_name("FILE.exr")
      ->check(not_empty())
      ->group(run_group)
      ->excludes(compare);
}

void add_material_options(CLI::App& app, Options& options) {
  add_material_option(app, options.materials)->group(scene_group);
  app.add_flag(
         "--multiple-scattering", options.multiple_scattering,
         "Metals and mirrors reflect also what bounces between their microfacets, up to 69 % where they are rough")
      ->group(scene_group);
  app.add_option("--material-cache", options.material_cache, "Keep the projections of files there, for the next run")
      ->type_name("DIRECTORY")
      ->check(not_empty())
      ->group(scene_group);
}

void add_light_options(CLI::App& app, LightOverrides& light) {
  add_point(app, "--light", light.position, "Where the spotlight is")->group(scene_group);
  add_point(app, "--light-target", light.target, "What it points at")->group(scene_group);
  add_angle(app, "--light-angle", 178.0f, 0.5f, light.half_angle, "Full angle of its cone")->group(scene_group);
  add_number_function(
      app, "--light-power", [&light](float watts) { light.power = watts; }, 1e-6f, 1e12f, "1e-6...1e12 watts",
      "What it sends into the cone, per colour channel; makes it white")
      ->type_name("WATTS")
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

void add_virtual_light_options(CLI::App& app, Options& options) {
  const std::string group = "Virtual lights";
  CLI::Option* lights =
      add_number(app, "--lights", options.lights, 1, most_lights, "1...10000000", "How many; rounded up to a square")
          ->group(group);
  add_number_function(
      app, "--time-budget", [&options](double seconds) { options.time_budget = seconds; }, 0.001, 1e6,
      "0.001...1e6 seconds", "As many as can be shot and gathered in that time")
      ->type_name("SECONDS")
      ->excludes(lights)
      ->group(group);
  add_choice(app, "--visibility", visibility_names, options.centre_visibility,
             "What stands between them and a surface: nothing, or what a ray to the light's centre meets")
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
  add_number(app, "--vpl-clamp", options.vpl_clamp, 0.0f, 100.0f, "0...100",
             "vpl: how many of a light's radii are the least distance that counts; 0 is no clamping")
      ->group(group);
  add_number(app, "--vsl-samples", options.vsl_samples, 1, 1024, "1...1024", "vsl: samples of each light's sphere")
      ->group(group);
  add_number(app, "--vsgl-texels", options.vsgl_texels, 1, 1024, "1...1024",
             "vsgl, vsgl-2024: side of the block of the map that one light stands for; --lights are the blocks")
      ->group(group);
}

void add_hvl_options(CLI::App& app, Options& options) {
  const std::string group = "Harmonics virtual lights";
  std::vector<int> bands = gather_bands();
  for (const int number : zonal_bands()) bands.push_back(number);
  std::sort(bands.begin(), bands.end());
  bands.erase(std::unique(bands.begin(), bands.end()), bands.end());
  add_one_of(app, "--bands", options.bands, bands,
             "Bands of the receiver's material: " + joined(gather_bands()) + " for hvl, " + joined(zonal_bands()) +
                 " for hvl-zonal")
      ->group(group);
  add_one_of(app, "--emission-bands", options.emission_bands, listed(compiled_emission_bands),
             "hvl: bands of the light that a virtual light sends out")
      ->group(group);
  add_choice(
      app, "--horizon", horizon_names, options.horizon,
      "hvl: the share of a light that the receiver's horizon leaves. The material cuts there too; a second cut offsets "
      "what spheres gain at grazing angles where all is visible. With --visibility centre none is nearer the "
      "truth")
      ->group(group);
  add_choice(app, "--window", window_names, options.window, "hvl: what tames the ringing of the materials")
      ->group(group);
}

void add_plan_options(CLI::App& app, Options& options) {
  const std::string group = "Tolerance";
  CLI::Option* tolerance =
      add_number(
          app, "--tolerance", options.tolerance, 0.0, 1.0, "0...1",
          "hvl: how far indirect light may be off, as a root mean square: 0.01 is 1 %. Lights are then drawn for "
          "many, as few as that allows; 0 gathers them all")
          ->group(group);
  app.get_option("--time-budget")->excludes(tolerance);
  add_number(app, "--check", options.checked_share, 0.0f, 1.0f, "0...1",
             "Gather that share of the pixels in full as well, and report the error measured")
      ->group(group);
  app.add_flag("--explain", options.explain, "Report what was left out, why, and what it saved")->group(group);
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

/// What speaks of a plan wants one, with bands that it is compiled for; its errors are measured where it is to be
/// explained.
void check_plan(const CLI::App& app, Options& options) {
  for (const char* option : {"--check", "--explain"}) {
    if (app.count(option) > 0 && !options.is_planned())
      throw InputError(std::string(option) + " means nothing without --tolerance");
  }
  if (options.is_planned() && !contains(compiled_planned_bands, options.bands)) {
    throw InputError("--tolerance: not for --bands " + std::to_string(options.bands) +
                     ": these numbers of bands are not compiled in");
  }
  constexpr float explained_hits = 500.0f;
  if (options.explain && app.count("--check") == 0) {
    options.checked_share =
        std::min(1.0f, explained_hits / (static_cast<float>(options.width) * static_cast<float>(options.height) *
                                         static_cast<float>(options.antialias * options.antialias)));
  }
}

/// Options of one method are refused beside another; those that several have, such as --lights, are not.
void check_methods(const CLI::App& app, const Options& options) {
  using Methods = std::vector<Method>;
  const Methods hvl{Method::hvl};
  const std::vector<std::pair<const char*, Methods>> users{
      {"--vpl-clamp", {Method::vpl}},
      {"--vsl-samples", {Method::vsl}},
      {"--vsgl-texels", {Method::vsgl, Method::vsgl_2024}},
      {"--bands", {Method::hvl, Method::hvl_zonal}},
      {"--time-budget", {Method::vpl, Method::vsl, Method::vsgl, Method::vsgl_2024, Method::hvl, Method::hvl_zonal}},
      {"--material-cache", hvl},
      {"--emission-bands", hvl},
      {"--horizon", hvl},
      {"--window", hvl},
      {"--tolerance", hvl},
      {"--check", hvl},
      {"--explain", hvl},
  };
  for (const auto& [option, methods] : users) {
    if (app.count(option) > 0 && std::find(methods.begin(), methods.end(), options.method) == methods.end()) {
      throw InputError(std::string(option) + " means nothing to --method " + name_of(method_names, options.method));
    }
  }
  if (options.comparing() && !options.needs_lights()) {
    throw InputError("--compare renders paths beside another method: choose one");
  }
}

void check_map(const Options& options) {
  if (options.time_budget) return;  // it chooses what fits
  const int side = map_side(options);
  if (side <= most_texels_across) return;
  throw InputError("--lights and --vsgl-texels ask for a map of " + std::to_string(side) +
                   " texels across, more than " + std::to_string(most_texels_across));
}

void check_bands(const Options& options) {
  const std::vector<int> bands = options.method == Method::hvl_zonal ? zonal_bands() : gather_bands();
  if (std::find(bands.begin(), bands.end(), options.bands) != bands.end()) return;
  throw InputError("--bands: '" + std::to_string(options.bands) + "' is not one of " + joined(bands) +
                   ", which --method " + name_of(method_names, options.method) + " has");
}

}  // namespace

int block_side(const Options& options) { return options.blocks() ? options.vsgl_texels : 1; }

int map_side(const Options& options) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(options.lights)))) * block_side(options);
}

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  CLI::App app(
      "Renders a scene lit by one spotlight: direct light, and one bounce by virtual\n"
      "lights or by paths.",
      "hvl-render");
  set_up(app);
  add_output_options(app, line.options);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_light_options(app, line.options.light);
  add_image_options(app, line.options);
  add_material_options(app, line.options);
  add_virtual_light_options(app, line.options);
  add_hvl_options(app, line.options);
  add_plan_options(app, line.options);
  add_path_options(app, line.options);
  line.exit_status = parse(app, argc, argv);
  if (!line.exit_status) {
    check_methods(app, line.options);
    check_bands(line.options);
    check_plan(app, line.options);
    check_map(line.options);
  }
  return line;
}

}  // namespace example::hvl_render
