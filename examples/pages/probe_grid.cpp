// Light probes on a grid: filled once, saved, loaded, and looked up wherever something stands. Needs GLM:
//
//   g++ -std=c++17 -O2 -march=native -Iinclude examples/pages/probe_grid.cpp -o probe_grid
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/zonal.hpp>

#include <algorithm>
#include <cstdio>
#include <thread>
#include <vector>

int main() {
  // Sphere lights of radiance 1 times a colour, about a room from (0, 0, 0) to (8, 3, 6).
  std::vector<zonal::ColouredLight<zonal::SphereLight<float>>> lamps;
  lamps.push_back({{{2.0F, 2.6F, 2.0F}, 0.2F}, {12, 10, 7}});
  lamps.push_back({{{6.5F, 2.6F, 4.0F}, 0.2F}, {3, 6, 12}});

  // Five bands of RGB at 9 x 4 x 7 vertices, with spatial gradients: 1200 bytes a vertex. Trilinear interpolation does
  // without them: zonal::CoefficientGrid<5, zonal::GridContent::values>, a quarter of that.
  zonal::CoefficientGrid<5> grid({0, 0, 0}, {8, 3, 6}, {9, 4, 7});

  // body(0) to body(count - 1) in any order, on as many threads as you like: here two.
  const auto on_two_threads = [](int count, const auto& body) {
    const auto part = [&](int first) {
      for (int i = first; i < count; i += 2) body(i);
    };
    std::thread other(part, 1);
    part(0);
    other.join();
  };
  zonal::add_lights(grid, lamps, on_two_threads);

  zonal::save_grid("probes.grid", grid);  // whole or not at all
  const auto probes = zonal::load_grid<5>("probes.grid");

  // In the frame: the light at a position, then what a matt surface of a normal makes of it. A vector of your own will
  // do for the position and, as a second template argument of interpolate, for the colours.
  const glm::vec3 normal(0, 1, 0);
  for (const float x : {1.5F, 3.5F, 5.5F, 7.5F}) {
    const auto radiance = zonal::interpolate<zonal::Interpolation::hermite>(probes, glm::vec3(x, 0.7F, 3.1F));
    const glm::vec3 e_over_pi = zonal::reconstruct_convolved(radiance, zonal::LambertLobe{}, normal);
    std::printf("x = %.1f: %.3f %.3f %.3f\n", double(x), double(e_over_pi.r), double(e_over_pi.g), double(e_over_pi.b));
  }
}

// It prints:
//   x = 1.5: 0.083 0.070 0.053
//   x = 3.5: 0.053 0.050 0.047
//   x = 5.5: 0.031 0.047 0.081
//   x = 7.5: 0.022 0.040 0.076
