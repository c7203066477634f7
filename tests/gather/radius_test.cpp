#include <zonal/gather/radius.hpp>

#include <cmath>
#include <vector>

#include "../catch.hpp"

namespace {

/// A flat map of width x height lights, one `spacing` from the next, all as far from the primary light.
std::vector<zonal::VirtualLight> flat_map(int width, int height, float spacing) {
  std::vector<zonal::VirtualLight> map;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      zonal::VirtualLight light;
      light.position = {spacing * static_cast<float>(column), spacing * static_cast<float>(row), 0};
      light.flux = glm::vec3(1);
      light.primary_distance = 5;
      light.radius = 77;
      map.push_back(light);
    }
  }
  return map;
}

}  // namespace

TEST_CASE("radius: r1 is the mean distance to the 8 neighbours, at borders to those there are") {
  auto map = flat_map(4, 3, 0.5F);
  zonal::set_neighbour_radii(map.data(), 4, 3, 2);
  const float root2 = std::sqrt(2.0F);
  CHECK(map[5].radius == Catch::Approx(2 * 0.5F * (4 + 4 * root2) / 8));
  CHECK(map[0].radius == Catch::Approx(2 * 0.5F * (2 + root2) / 3));
  CHECK(map[1].radius == Catch::Approx(2 * 0.5F * (3 + 2 * root2) / 5));
}

TEST_CASE("radius: r1 weights neighbours by how alike their distance to the primary light is, and skips dark ones") {
  auto map = flat_map(3, 1, 1);
  map[2].position.x = 9;  // 8 from the middle, and far behind it
  map[2].primary_distance = 5 + 3;
  zonal::set_neighbour_radii(map.data(), 3, 1, 1, 0.5F);
  const float near = 1 / 0.5F, far = 1 / 3.5F;
  CHECK(map[1].radius == Catch::Approx((near * 1 + far * 8) / (near + far)));

  map[2].flux = glm::vec3(0);
  zonal::set_neighbour_radii(map.data(), 3, 1, 1);
  CHECK(map[1].radius == Catch::Approx(1));
  map[0].flux = glm::vec3(0);
  map[1].radius = 77;
  zonal::set_neighbour_radii(map.data(), 3, 1, 1);
  CHECK(map[1].radius == 77);  // no neighbour: kept
}

TEST_CASE("radius: r2 is the distance between diagonal neighbours of the map, on a sphere about the primary light") {
  for (const int side : {4, 10, 100}) {
    auto map = flat_map(side, side, 1);
    const float field_of_view = 1.2F;
    zonal::set_field_of_view_radii(map.data(), side * side, field_of_view, 1.5F);
    const double exact = std::tan(std::sqrt(2.0) * static_cast<double>(field_of_view) / side);
    CAPTURE(side);
    CHECK(map[3].radius == Catch::Approx(1.5 * 5 * exact).epsilon(side < 10 ? 2e-2 : 1e-3));
  }
}

TEST_CASE("radius: fixed is fixed") {
  auto map = flat_map(2, 2, 1);
  zonal::set_fixed_radii(map.data(), 4, 0.25F);
  for (const auto& light : map) CHECK(light.radius == 0.25F);
}
