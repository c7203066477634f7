// Repairs against their definitions.
#include <zonal/field/repair.hpp>

#include <cmath>
#include <random>

#include "../catch.hpp"

namespace {

using zonal::LatticePoint;
using zonal::Repair;

std::vector<LatticePoint> random_lattice(const glm::ivec3& size, double holes, std::mt19937& random) {
  std::vector<LatticePoint> points(zonal::detail::lattice_size(size));
  std::uniform_real_distribution<float> uniform(0, 1);
  for (LatticePoint& point : points) {
    if (double(uniform(random)) >= holes) point = {uniform(random), uniform(random), uniform(random), 1};
  }
  return points;
}

}  // namespace

TEST_CASE("a hole's nearest is the nearest") {
  std::mt19937 random(1);
  for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(40, 30, 1), glm::ivec3(1, 1, 50), glm::ivec3(7, 9, 8)}) {
    for (const double holes : {0.0, 0.5, 0.97}) {
      auto points = random_lattice(size, holes, random);
      points[random() % points.size()] = {5, 6, 7, 1};
      auto repaired = points;
      REQUIRE(repair(Repair::nearest, repaired.data(), size));
      zonal::detail::for_each_point(size, [&](int i, int j, int k, std::size_t number) {
        int least = 1 << 30;
        bool is_found = false;
        const auto visit_all = [&](const auto& visit) {
          zonal::detail::for_each_point(size, [&](int x, int y, int z, std::size_t other) {
            const int distance2 = (x - i) * (x - i) + (y - j) * (y - j) + (z - k) * (z - k);
            if (points[other].weight > 0) visit(distance2, points[other]);
          });
        };
        visit_all([&](int distance2, const LatticePoint&) { least = (std::min)(least, distance2); });
        visit_all([&](int distance2, const LatticePoint& point) {
          const LatticePoint& has = repaired[number];
          is_found = is_found || (distance2 == least && has.r == point.r && has.g == point.g && has.b == point.b);
        });
        INFO(size.x << 'x' << size.y << 'x' << size.z << ' ' << i << ' ' << j << ' ' << k);
        REQUIRE(is_found);
        REQUIRE(repaired[number].weight == 1);
      });
    }
  }
}

TEST_CASE("mip-maps leave what is there, and stay between its extremes") {
  std::mt19937 random(2);
  for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(33, 20, 1), glm::ivec3(1, 1, 50), glm::ivec3(7, 9, 8)}) {
    auto points = random_lattice(size, 0.9, random);
    points[0] = {0.5F, 0.5F, 0.5F, 1};
    auto repaired = points;
    REQUIRE(repair(Repair::mip_maps, repaired.data(), size));
    float least = 1, most = 0;
    for (const LatticePoint& point : points) {
      if (point.weight > 0) least = (std::min)(least, point.r), most = (std::max)(most, point.r);
    }
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (points[n].weight > 0) REQUIRE(repaired[n].r == points[n].r);
      REQUIRE(repaired[n].weight == 1);
      REQUIRE(repaired[n].r >= least - 1e-6F);
      REQUIRE(repaired[n].r <= most + 1e-6F);
    }
  }
}

TEST_CASE("a hole in a row, by mip-maps, by hand") {
  // 0 and 3 are there. Half: {0}, {3}; point 1 is a quarter from 0 to 3, point 2 three quarters.
  std::vector<LatticePoint> points(4);
  points[0] = {0, 0, 0, 1}, points[3] = {3, 3, 3, 1};
  REQUIRE(repair(Repair::mip_maps, points.data(), {4, 1, 1}));
  REQUIRE(points[1].r == 0.75F);
  REQUIRE(points[2].r == 2.25F);
}

TEST_CASE("nothing is repaired from nothing") {
  std::vector<LatticePoint> points(12);
  REQUIRE(!repair(Repair::mip_maps, points.data(), {4, 3, 1}));
  REQUIRE(!repair(Repair::nearest, points.data(), {4, 3, 1}));
}
