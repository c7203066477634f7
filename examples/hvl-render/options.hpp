#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "image.hpp"

namespace hvl_render {

enum class Method { hvl, path };
enum class RadiusRule { neighbours, field_of_view, fixed };  // r1, r2, metres
enum class HorizonRule { smoothstep, exact };
enum class WindowRule { none, hann, sinc };

/// What --camera and its like replace in a scene.
struct ViewOverrides {
  std::optional<glm::vec3> camera_position;
  std::optional<glm::vec3> camera_target;
  std::optional<float> vertical_field_of_view;  // radians
  std::optional<glm::vec3> light_position;
  std::optional<glm::vec3> light_target;
  std::optional<float> light_power;       // W per channel, into the whole cone
  std::optional<float> light_half_angle;  // radians
};

struct Options {
  std::string scene = "atrium";
  bool stage = true;
  ViewOverrides view;

  Method method = Method::hvl;
  int lights = 400;
  int bands = 5;
  int emission_bands = 3;
  RadiusRule radius = RadiusRule::field_of_view;
  float fixed_radius = 0.0f;  // metres
  float radius_factor = 1.0f;
  HorizonRule horizon = HorizonRule::smoothstep;
  WindowRule window = WindowRule::none;

  int samples_per_pixel = 256;
  int bounces = 1;
  std::uint64_t seed = 1;

  int width = 640;
  int height = 512;
  int antialias = 2;
  Display display;

  std::string out = "hvl-render.png";
  std::string compare_directory;  // empty: render one image by `method`
  std::string reference;
  std::string report;
  int threads = 0;  // 0: all
  bool quiet = false;

  bool comparing() const { return !compare_directory.empty(); }
  bool needs_lights() const { return comparing() || method == Method::hvl; }
  bool needs_paths() const { return comparing() || method == Method::path; }
};

struct CommandLine {
  Options options;
  std::optional<int> exit_status;  // set where --help has said all
};

/// Throws InputError with one line about what is wrong.
CommandLine parse_command_line(int argc, char** argv);

}  // namespace hvl_render
