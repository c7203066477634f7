#include "command_line.hpp"

#include <cmath>
#include <filesystem>
#include <memory>

#include <zonal/version.hpp>

#include "help_formatter.hpp"
#include "input_error.hpp"
#include "names.hpp"

namespace example {
namespace {

CLI::Validator image_size() {
  return validator([](const std::string& text) -> std::string {
    std::array<int, 2> size{};
    const auto possible = [](int length) { return length >= 1 && length <= 16384; };
    if (parse_numbers(text, 'x', size) && possible(size[0]) && possible(size[1])) return {};
    return "'" + text + "' is not a size such as 640x512, each side 1 to 16384";
  });
}

/// One line about what is wrong, in other words than CLI11's where those are hard to read.
std::string message(const CLI::ParseError& error) {
  const std::string text = one_line(error.what());
  if (error.get_name() != "ArgumentMismatch") return text;
  return text.substr(0, text.find(':')) + " needs a value";
}

std::string version(const std::string& program) {
  return program + " " + std::to_string(zonal::version_major) + "." + std::to_string(zonal::version_minor) + "." +
         std::to_string(zonal::version_patch);
}

/// x,y,z,x,y,z
bool parse_box(const std::string& text, Bounds& box) {
  std::array<float, 6> n{};
  const auto is_finite = [](float x) { return std::isfinite(x); };
  if (!parse_numbers(text, ',', n) || !std::all_of(n.begin(), n.end(), is_finite)) return false;
  box = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  return true;
}

CLI::Validator box_corners() {
  return validator([](const std::string& text) -> std::string {
    Bounds ignored;
    return parse_box(text, ignored) ? "" : "'" + text + "' is not a box such as -0.5,1,2,0.5,2,3";
  });
}

std::string scene_names() {
  std::string text;
  for (const auto& [name, finish] : atrium_names) text += name + "|";
  return text + "furnace|rooms|FILE.obj";
}

}  // namespace

CLI::Validator validator(const std::function<std::string(const std::string&)>& check) {
  return CLI::Validator(check, "");
}

CLI::Validator not_empty() {
  return validator([](const std::string& text) { return text.empty() ? "the name is empty" : ""; });
}

CLI::Validator image_name() {
  return validator([](const std::string& text) -> std::string {
    const std::filesystem::path extension = std::filesystem::path(text).extension();
    if (extension == ".png" || extension == ".exr") return {};
    return "'" + text + "' does not end in .png or .exr";
  });
}

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : "|") + std::to_string(number);
  return text;
}

CLI::Validator one_of(const std::vector<int>& allowed) {
  return validator([allowed](const std::string& given) -> std::string {
    int number = 0;
    const bool found =
        parse_number(given, number) && std::find(allowed.begin(), allowed.end(), number) != allowed.end();
    return found ? std::string() : "'" + given + "' is not one of " + joined(allowed);
  });
}

CLI::Option* add_point(CLI::App& app, const std::string& name, std::optional<glm::vec3>& point,
                       const std::string& help) {
  const auto assign = [&point, name](const std::string& text) {
    std::array<float, 3> parsed{};
    // As in OBJ files: beyond, squares are no floats.
    const auto possible = [](float coordinate) { return std::abs(coordinate) <= 1e8f; };
    if (!parse_numbers(text, ',', parsed) || !std::all_of(parsed.begin(), parsed.end(), possible))
      throw CLI::ValidationError(name, "'" + text + "' is not a point x,y,z of coordinates up to 1e8");
    point = glm::vec3(parsed[0], parsed[1], parsed[2]);
  };
  return app.add_option_function<std::string>(name, assign, help)->type_name("X,Y,Z");
}

CLI::Option* add_box_option(CLI::App& app, std::optional<Bounds>& box, const std::string& help) {
  const auto set = [&box](const std::string& text) { parse_box(text, box.emplace()); };
  return app.add_option_function<std::string>("--box", set, "Low and high corner " + help)
      ->type_name("X,Y,Z,X,Y,Z")
      ->check(box_corners());
}

CLI::Option* add_resolution_option(CLI::App& app, glm::ivec3& resolution, int most, const std::string& help) {
  const auto parse_resolution = [](const std::string& text, std::array<int, 3>& numbers) {
    int all = 0;
    if (!parse_number(text, all)) return parse_numbers(text, 'x', numbers);
    numbers.fill(all);
    return true;
  };
  const auto set = [=, &resolution](const std::string& text) {
    std::array<int, 3> numbers{};
    parse_resolution(text, numbers);
    resolution = {numbers[0], numbers[1], numbers[2]};
  };
  const auto check = [=](const std::string& text) -> std::string {
    std::array<int, 3> numbers{};
    const auto possible = [=](int number) { return number >= 2 && number <= most; };
    if (parse_resolution(text, numbers) && std::all_of(numbers.begin(), numbers.end(), possible)) return {};
    return "'" + text + "' is not a resolution such as 8 or 8x8x8, each number 2 to " + std::to_string(most);
  };
  return app.add_option_function<std::string>("--grid", set, help)
      ->type_name("N|XxYxZ")
      ->check(validator(check))
      ->default_str(std::to_string(resolution.x));
}

CLI::Option* add_angle(CLI::App& app, const std::string& name, float greatest_degrees, float scale,
                       std::optional<float>& radians, const std::string& help) {
  const auto assign = [&radians, scale](float degrees) { radians = scale * glm::radians(degrees); };
  const std::string range = "1..." + std::to_string(static_cast<int>(greatest_degrees)) + " degrees";
  return add_number_function(app, name, assign, 1.0f, greatest_degrees, range, help);
}

CLI::Option* add_one_of(CLI::App& app, const std::string& name, int& number, const std::vector<int>& allowed,
                        const std::string& help) {
  const auto assign = [&number](const std::string& text) { parse_number(text, number); };
  return app.add_option_function<std::string>(name, assign, help)
      ->type_name(joined(allowed))
      ->check(one_of(allowed))
      ->default_str(std::to_string(number));
}

CLI::Option* add_compare_option(CLI::App& app, CommonOptions& options, const std::string& help) {
  return app.add_option("--compare", options.compare_directory, help)
      ->type_name("DIRECTORY")
      ->check(not_empty())
      ->group(run_group);
}

CLI::Option* add_out_option(CLI::App& app, CommonOptions& options) {
  return app.add_option("--out", options.out, "The picture: PNG for the screen, or EXR of linear radiance")
      ->type_name("FILE.png|FILE.exr")
      ->check(image_name())
      ->capture_default_str()
      ->group(run_group);
}

void add_run_options(CLI::App& app, CommonOptions& options) {
  app.add_option("--report", options.report, "Write options, times, counts and errors there")
      ->type_name("FILE.json")
      ->check(not_empty())
      ->group(run_group);
  add_thread_options(app, options);
}

void add_thread_options(CLI::App& app, CommonOptions& options) {
  add_number(app, "--threads", options.threads, 0, 1024, "0...1024", "How many; 0 is all of the machine's")
      ->group(run_group);
  app.add_flag("--quiet", options.quiet, "Print neither progress nor the table")->group(run_group);
}

void add_scene_choice(CLI::App& app, CommonOptions& options) {
  app.add_option("--scene", options.scene,
                 "The built-in hall, all matte, glossy all over, with rough floor and walls, or open above; the inside "
                 "of a white sphere; "
                 "or a Wavefront OBJ file with its MTL and pictures: map_Kd, norm, map_Bump")
      ->type_name(scene_names())
      ->check(not_empty())
      ->capture_default_str()
      ->group(scene_group);
  app.add_flag_callback(
         "--no-stage", [&options] { options.obj.stage = false; }, "Show an OBJ alone, not on a floor before two walls")
      ->group(scene_group);
  add_choice(app, "--up", up_names, options.obj.up, "Which axis of an OBJ points up; it becomes y")->group(scene_group);
  add_choice(app, "--view", place_names, options.obj.place,
             "Where an OBJ is seen from; auto is from inside where it is a room")
      ->group(scene_group);
}

void add_scene_options(CLI::App& app, CommonOptions& options) {
  add_scene_choice(app, options);
  CameraOverrides& camera = options.camera;
  add_point(app, "--camera", camera.position, "Where the camera is, in metres; y is up")->group(scene_group);
  add_point(app, "--target", camera.target, "What it looks at")->group(scene_group);
  add_angle(app, "--fov", 170.0f, 1.0f, camera.vertical_field_of_view, "Its vertical field of view")
      ->group(scene_group);
}

void add_image_options(CLI::App& app, CommonOptions& options) {
  const std::string group = "Image";
  const auto set_size = [&options](const std::string& text) {
    std::array<int, 2> size{};
    parse_numbers(text, 'x', size);
    options.width = size[0];
    options.height = size[1];
  };
  app.add_option_function<std::string>("--size", set_size, "In pixels")
      ->type_name("WIDTHxHEIGHT")
      ->check(image_size())
      ->default_str(std::to_string(options.width) + "x" + std::to_string(options.height))
      ->group(group);
  add_number(app, "--antialias", options.antialias, 1, 16, "1...16", "A: A x A positions in each pixel")->group(group);
  add_number(app, "--exposure", options.display.exposure_stops, -30.0f, 30.0f, "-30...30",
             "Stops brighter, in PNG files and for the errors")
      ->group(group);
  add_choice(app, "--tone", tone_names, options.display.tone_map,
             "From radiance to sRGB by a film curve, or cut off at 1")
      ->group(group);
}

void set_up(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", version(app.get_name()), "Print the version and exit");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw InputError(message(error));
  }
  return std::nullopt;
}

}  // namespace example
