// A fragment shader put together from generated functions and a main of one's own, ready for glShaderSource, and what
// it computes: the functions are the library's, here called in C++.
#include <zonal/zonal.hpp>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "light.inl"  // the generated functions in C++, without any other header of zonal

int main() {
  std::ostringstream functions;
  functions << std::ifstream(FUNCTIONS).rdbuf();
  const std::string shader = "#version 300 es\nprecision highp float;\n" + functions.str() + R"(
uniform vec3 radiance[9];
in vec3 normal;
out vec4 colour;
void main() { colour = vec4(zonal_reconstruct_lambert_colour_3(radiance, normalize(normal)), 1.0); }
)";
  std::ofstream("floor_light.frag") << shader;

  // A lamp of radius 1 and radiance (4, 2, 1), 3 above: what a white floor sends out.
  float cap[3];
  zonal_sphere_cap_3(3.0F, 1.0F, cap);
  const auto light = zonal::orient(zonal::Zh<3, float>{{cap[0], cap[1], cap[2]}}, std::array{0.0F, 0.0F, 1.0F});
  float radiance[9][3];
  for (int i = 0; i < 9; ++i) {
    for (int c = 0; c < 3; ++c) radiance[i][c] = light[i] * std::array{4.0F, 2.0F, 1.0F}[c];
  }
  float reflected[3];
  const float up[3] = {0, 0, 1};
  zonal_reconstruct_lambert_colour_3(radiance, up, reflected);
  const float by_library = 4 * zonal::reconstruct_convolved(light, zonal::LambertLobe{}, up);
  std::printf("floor_light.frag has %s; the floor sends out %.4f %.4f %.4f, red by the library %.4f\n",
              shader.find("zonal_sphere_cap_3") != std::string::npos ? "the functions" : "nothing",
              double(reflected[0]), double(reflected[1]), double(reflected[2]), double(by_library));
}

// It prints:
//   floor_light.frag has the functions; the floor sends out 0.4675 0.2338 0.1169, red by the library 0.4675
