#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <zonal/transform/window.hpp>

#include "shared/common_options.hpp"
#include "shared/material_change.hpp"

namespace example::hvl_render {

enum class Method { vpl, vsl, vsgl, vsgl_2024, hvl, hvl_zonal, path };
enum class RadiusRule { neighbours, field_of_view, fixed };  // r1, r2, metres
enum class HorizonRule { none, smoothstep, exact };

/// What --light and its like replace in a scene.
struct LightOverrides {
  std::optional<glm::vec3> position;
  std::optional<glm::vec3> target;
  std::optional<float> power;       // W per channel, into the whole cone
  std::optional<float> half_angle;  // radians
};

struct Options : CommonOptions {
  Options() { out = "hvl-render.png"; }

  LightOverrides light;

  std::vector<MaterialChange> materials;
  bool multiple_scattering = false;
  std::string material_cache;  // a directory; empty: none

  Method method = Method::hvl;
  int lights = 400;
  std::optional<double> time_budget;  // seconds for lights and gather; sets the number of lights
  bool centre_visibility = false;
  float vpl_clamp = 0.0f;  // radii
  int vsl_samples = 25;
  int vsgl_texels = 8;
  int bands = 5;
  int emission_bands = 3;
  RadiusRule radius = RadiusRule::field_of_view;
  float fixed_radius = 0.0f;  // metres
  float radius_factor = 1.0f;
  HorizonRule horizon = HorizonRule::smoothstep;
  zonal::Window window = zonal::Window::none;

  double tolerance = 0.0;      // root mean square error, of that of the indirect light; 0: all lights
  float checked_share = 0.0f;  // of hits that are gathered in full as well
  bool explain = false;

  int samples_per_pixel = 256;
  int bounces = 1;
  std::uint64_t seed = 1;

  std::string reference;

  bool blocks() const { return method == Method::vsgl || method == Method::vsgl_2024; }  // of the map, a light each
  bool needs_lights() const { return method != Method::path; }
  bool is_planned() const { return tolerance > 0.0; }
  bool needs_paths() const { return comparing() || method == Method::path; }
};

/// What --lights and a map can be at most: more texels would ask for gigabytes.
inline constexpr int most_lights = 10000000;
inline constexpr int most_texels_across = 3200;

/// Texels along one side of what one light stands for.
int block_side(const Options& options);
/// The side of the square map for the options' lights: as many lights at least, or as many blocks.
int map_side(const Options& options);

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::hvl_render
