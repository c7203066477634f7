#include "options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <zonal/version.hpp>

#include "gather_hvl.hpp"
#include "help_formatter.hpp"
#include "input_error.hpp"
#include "option_names.hpp"

namespace hvl_render {
namespace {

/// The whole text as one number.
template <class Number>
bool parse_number(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && !text.empty();
}

using Check = std::function<std::string(const std::string&)>;

// The ranges below stand in --help as the names of types, so the validators themselves say nothing there.

/// A number within bounds; `text` is how they read.
template <class Number>
CLI::Validator between(Number least, Number greatest, const std::string& text) {
  const Check check = [=](const std::string& given) -> std::string {
    Number number{};
    if (parse_number(given, number) && number >= least && number <= greatest) return {};
    return "'" + given + "' is not in " + text;
  };
  return CLI::Validator(check, "");
}

CLI::Validator image_size() {
  const Check check = [](const std::string& text) -> std::string {
    const std::size_t cross = text.find('x');
    int width = 0;
    int height = 0;
    const bool numbers = cross != std::string::npos && parse_number(text.substr(0, cross), width) &&
                         parse_number(text.substr(cross + 1), height);
    const auto possible = [](int length) { return length >= 1 && length <= 16384; };
    if (numbers && possible(width) && possible(height)) return {};
    return "'" + text + "' is not a size such as 640x512, each side 1 to 16384";
  };
  return CLI::Validator(check, "");
}

CLI::Validator radius_rule() {
  const Check check = [](const std::string& text) -> std::string {
    float metres = 0.0f;
    const bool number = parse_number(text, metres) && metres > 0.0f && std::isfinite(metres);
    if (text == "r1" || text == "r2" || number) return {};
    return "'" + text + "' is neither r1 nor r2 nor a positive number of metres";
  };
  return CLI::Validator(check, "");
}

CLI::Validator not_empty() {
  const Check check = [](const std::string& text) { return text.empty() ? "the name is empty" : ""; };
  return CLI::Validator(check, "");
}

CLI::Validator image_name() {
  const Check check = [](const std::string& text) -> std::string {
    const std::filesystem::path extension = std::filesystem::path(text).extension();
    if (extension == ".png" || extension == ".exr") return {};
    return "'" + text + "' does not end in .png or .exr";
  };
  return CLI::Validator(check, "");
}

/// 1|3|5
std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : "|") + std::to_string(number);
  return text;
}

CLI::Validator one_of(const std::vector<int>& allowed) {
  const Check check = [allowed](const std::string& given) -> std::string {
    int number = 0;
    const bool found =
        parse_number(given, number) && std::find(allowed.begin(), allowed.end(), number) != allowed.end();
    return found ? std::string() : "'" + given + "' is not one of " + joined(allowed);
  };
  return CLI::Validator(check, "");
}

/// An option whose words stand for the values of an enumeration.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const Names<Value>& names, Value& chosen,
                        const std::string& help) {
  std::string text;
  for (const auto& [word, value] : names) text += (text.empty() ? "" : "|") + word;
  const auto assign = [&names, &chosen, name, text](const std::string& given) {
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == given; });
    if (found == names.end()) throw CLI::ValidationError(name, "'" + given + "' is not one of " + text);
    chosen = found->second;
  };
  return app.add_option_function<std::string>(name, assign, help)->type_name(text)->default_str(name_of(names, chosen));
}

/// A number with a default, within bounds; `range` is how they read.
template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& number, Number least, Number greatest,
                        const std::string& range, const std::string& help) {
  return app.add_option(name, number, help)
      ->type_name(range)
      ->check(between(least, greatest, range))
      ->capture_default_str();
}

/// A point x,y,z in metres.
CLI::Option* add_point(CLI::App& app, const std::string& name, std::optional<glm::vec3>& point,
                       const std::string& help) {
  const auto assign = [&point, name](const std::string& text) {
    glm::vec3 parsed{};
    std::size_t start = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t end = axis < 2 ? text.find(',', start) : text.size();
      const bool number = end != std::string::npos && parse_number(text.substr(start, end - start), parsed[axis]);
      if (!number || !std::isfinite(parsed[axis]))
        throw CLI::ValidationError(name, "'" + text + "' is not a point x,y,z");
      start = end + 1;
    }
    point = parsed;
  };
  return app.add_option_function<std::string>(name, assign, help)->type_name("X,Y,Z");
}

/// An angle given in degrees and kept, times `scale`, in radians.
CLI::Option* add_angle(CLI::App& app, const std::string& name, float greatest_degrees, float scale,
                       std::optional<float>& radians, const std::string& help) {
  const auto assign = [&radians, scale](const float& degrees) { radians = scale * glm::radians(degrees); };
  const std::string range = "1..." + std::to_string(static_cast<int>(greatest_degrees)) + " degrees";
  return app.add_option_function<float>(name, assign, help)
      ->type_name(range)
      ->check(between(1.0f, greatest_degrees, range));
}

void add_run_options(CLI::App& app, Options& options) {
  const std::string group = "Run and output";
  CLI::Option* compare =
      app.add_option("--compare", options.compare_directory,
                     "Render by both methods, and write hvl, reference and difference (red: hvl is brighter) "
                     "there; excludes --method, --out and --reference")
          ->type_name("DIRECTORY")
          ->check(not_empty())
          ->group(group);
  add_choice(app, "--method", method_names, options.method, "Virtual lights, or Monte Carlo paths")
      ->group(group)
      ->excludes(compare);
  app.add_option("--out", options.out, "The picture: PNG for the screen, or EXR of linear radiance")
      ->type_name("FILE.png|FILE.exr")
      ->check(image_name())
      ->capture_default_str()
      ->group(group)
      ->excludes(compare);
  app.add_option("--reference", options.reference, "Compare the picture with this one of the same size")
      ->type_name("FILE.exr")
      ->check(not_empty())
      ->group(group)
      ->excludes(compare);
  app.add_option("--report", options.report, "Write options, times, counts and errors there")
      ->type_name("FILE.json")
      ->check(not_empty())
      ->group(group);
  add_number(app, "--threads", options.threads, 0, 1024, "0...1024", "How many; 0 is all of the machine's")
      ->group(group);
  app.add_flag("--quiet", options.quiet, "Print neither progress nor the table")->group(group);
}

void add_scene_options(CLI::App& app, Options& options) {
  const std::string group = "Scene";
  app.add_option("--scene", options.scene, "The built-in hall, or a Wavefront OBJ file with its MTL")
      ->type_name("atrium|FILE.obj")
      ->check(not_empty())
      ->capture_default_str()
      ->group(group);
  app.add_flag_callback(
         "--no-stage", [&options] { options.stage = false; }, "Show an OBJ alone, not on a floor before two walls")
      ->group(group);
  ViewOverrides& view = options.view;
  add_point(app, "--camera", view.camera_position, "Where the camera is, in metres; y is up")->group(group);
  add_point(app, "--target", view.camera_target, "What it looks at")->group(group);
  add_angle(app, "--fov", 170.0f, 1.0f, view.vertical_field_of_view, "Its vertical field of view")->group(group);
  add_point(app, "--light", view.light_position, "Where the spotlight is")->group(group);
  add_point(app, "--light-target", view.light_target, "What it points at")->group(group);
  add_angle(app, "--light-angle", 178.0f, 0.5f, view.light_half_angle, "Full angle of its cone")->group(group);
  app.add_option_function<float>(
         "--light-power", [&view](const float& watts) { view.light_power = watts; },
         "What it sends into the cone, per colour channel; makes it white")
      ->type_name("WATTS")
      ->check(between(1e-6f, 1e12f, "1e-6...1e12 watts"))
      ->group(group);
}

void add_image_options(CLI::App& app, Options& options, std::string& size) {
  const std::string group = "Image";
  app.add_option("--size", size, "In pixels")
      ->type_name("WIDTHxHEIGHT")
      ->check(image_size())
      ->capture_default_str()
      ->group(group);
  add_number(app, "--antialias", options.antialias, 1, 16, "1...16", "A: A x A positions in each pixel")->group(group);
  add_number(app, "--exposure", options.display.exposure_stops, -30.0f, 30.0f, "-30...30",
             "Stops brighter, in PNG files and for the errors")
      ->group(group);
  add_choice(app, "--tone", tone_names, options.display.tone_map,
             "From radiance to sRGB by a film curve, or cut off at 1")
      ->group(group);
}

void add_hvl_options(CLI::App& app, Options& options, std::string& radius) {
  const std::string group = "Harmonics virtual lights";
  add_number(app, "--lights", options.lights, 1, 1000000, "1...1000000", "How many; rounded up to a square")
      ->group(group);
  app.add_option("--bands", options.bands, "Bands of the receiver's material")
      ->type_name(joined(gather_bands()))
      ->check(one_of(gather_bands()))
      ->capture_default_str()
      ->group(group);
  app.add_option("--emission-bands", options.emission_bands, "Bands of the light that a virtual light sends out")
      ->type_name(joined(emission_bands()))
      ->check(one_of(emission_bands()))
      ->capture_default_str()
      ->group(group);
  app.add_option("--radius", radius,
                 "By the distances to neighbours (r1), by the cone's angle (r2), or the same for all")
      ->type_name("r1|r2|METRES")
      ->check(radius_rule())
      ->capture_default_str()
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

void read_size(const std::string& size, Options& options) {
  const std::size_t cross = size.find('x');
  parse_number(size.substr(0, cross), options.width);
  parse_number(size.substr(cross + 1), options.height);
}

void read_radius(const std::string& radius, Options& options) {
  if (radius == "r1") {
    options.radius = RadiusRule::neighbours;
  } else if (radius == "r2") {
    options.radius = RadiusRule::field_of_view;
  } else {
    options.radius = RadiusRule::fixed;
    parse_number(radius, options.fixed_radius);
  }
}

/// One line about what is wrong, in other words than CLI11's where those are hard to read.
std::string message(const CLI::ParseError& error) {
  const std::string text = one_line(error.what());
  if (error.get_name() != "ArgumentMismatch") return text;
  return text.substr(0, text.find(':')) + " needs a value";
}

std::string version() {
  return "hvl-render " + std::to_string(zonal::version_major) + "." + std::to_string(zonal::version_minor) + "." +
         std::to_string(zonal::version_patch);
}

}  // namespace

CommandLine parse_command_line(int argc, char** argv) {
  CommandLine line;
  std::string size = "640x512";
  std::string radius = "r2";
  CLI::App app(
      "Renders a scene lit by one spotlight: direct light, and one bounce by Harmonics\n"
      "Virtual Lights or by paths.",
      "hvl-render");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", version(), "Print the version and exit");
  // So that what is added to a script's options counts.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  add_run_options(app, line.options);
  add_scene_options(app, line.options);
  add_image_options(app, line.options, size);
  add_hvl_options(app, line.options, radius);
  add_path_options(app, line.options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    line.exit_status = app.exit(success);
    return line;
  } catch (const CLI::ParseError& error) {
    throw InputError(message(error));
  }
  read_size(size, line.options);
  read_radius(radius, line.options);
  return line;
}

}  // namespace hvl_render
