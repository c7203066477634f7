// The light of the gradient paper's Table 2 and Fig. 15: a square cut into triangles, each of its own colour.
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <zonal/grid/light_sums.hpp>
#include <zonal/light/triangle.hpp>

namespace zonal_bench {

using zonal::ColouredLight;

/// 2 side^2 triangles over the square from -1 to 1 at the height z = 2.
inline std::vector<ColouredLight<zonal::TriangleLight<float>>> square_of_triangles(int side) {
  std::vector<ColouredLight<zonal::TriangleLight<float>>> lights;
  const auto size = static_cast<float>(side);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const auto corner = [&](int a, int b) {
        return glm::vec3(-1 + 2 * static_cast<float>(i + a) / size, -1 + 2 * static_cast<float>(j + b) / size, 2);
      };
      const glm::vec3 colour(0.2F + static_cast<float>(i) / size, 0.5F, static_cast<float>(j) / size);
      lights.push_back({{{corner(0, 0), corner(1, 0), corner(0, 1)}}, colour});
      lights.push_back({{{corner(1, 0), corner(1, 1), corner(0, 1)}}, 0.9F * colour});
    }
  }
  return lights;
}

/// Each as a sphere with the cosine of its normal.
inline std::vector<ColouredLight<zonal::TriangleSphereLight<float>>> as_modulated_spheres(
    const std::vector<ColouredLight<zonal::TriangleLight<float>>>& triangles) {
  std::vector<ColouredLight<zonal::TriangleSphereLight<float>>> lights;
  for (const auto& triangle : triangles) {
    lights.push_back({zonal::TriangleSphereLight<float>::approximate(triangle.light), triangle.colour});
  }
  return lights;
}

/// Each as a sphere.
inline std::vector<ColouredLight<zonal::SphereLight<float>>> as_spheres(
    const std::vector<ColouredLight<zonal::TriangleLight<float>>>& triangles) {
  std::vector<ColouredLight<zonal::SphereLight<float>>> lights;
  for (const auto& light : as_modulated_spheres(triangles)) {
    lights.push_back({{light.light.center, light.light.radius}, light.colour});
  }
  return lights;
}

template <int V>
zonal::PolygonLight<V, double> widened(const zonal::PolygonLight<V, float>& light) {
  zonal::PolygonLight<V, double> wide;
  for (int v = 0; v < V; ++v) wide.vertices[v] = glm::dvec3(light.vertices[v]);
  return wide;
}

}  // namespace zonal_bench
