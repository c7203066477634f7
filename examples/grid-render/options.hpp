#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <zonal/grid/interpolation_weights.hpp>
#include <zonal/transform/window.hpp>

#include "shared/common_options.hpp"

namespace example::grid_render {

/// How the coefficients at a point come about: interpolated, or, without a value, by projecting each light there.
using Method = std::optional<zonal::Interpolation>;

/// What a lantern or a texel is: a sphere, or a square of its disc's area as two triangles, exactly or as spheres.
enum class Shape { spheres, triangles, triangle_spheres };

struct Options : CommonOptions {
  Options() { out = "grid-render.png"; }

  int lights = 648;
  std::string texture;                  // empty: lanterns
  int texture_size = 64;                // texels on the longer side
  std::optional<float> quadtree_error;  // none: a light for each texel
  Shape shape = Shape::spheres;

  int bands = 5;
  int lobe_bands = 9;
  zonal::Window window = zonal::Window::none;
  glm::ivec3 grid{8};
  Method method = zonal::Interpolation::hermite;
  int paths = 0;                  // at each vertex and point seen; 0: lights that nothing blocks
  bool is_visible = false;        // look-ups weigh vertices by what is seen of them
  bool comparing_shapes = false;  // of the two that compare into a directory
  std::string save_grid;          // empty: nowhere
  std::string load_grid;          // empty: computed
  double tolerance = 0.0;         // root mean square error, of that of the light; 0: as the other options say
  bool explain = false;

  bool is_planned() const { return tolerance > 0.0; }
};

/// The numbers of bands that are compiled in: each costs compile time. Those of spheres are all there are.
std::vector<int> lighting_bands(Shape shape);
inline constexpr int most_lobe_bands = 9;

/// Throws InputError with one line about what is wrong.
CommandLine<Options> parse_command_line(int argc, char** argv);

}  // namespace example::grid_render
