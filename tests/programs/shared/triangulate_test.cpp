// Faces of many corners: their triangles against Newell's area, and point by point against the even-odd rule.
#include "shared/triangulate.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "catch.hpp"

namespace {

using namespace example;

using Polygon = std::vector<glm::dvec2>;

constexpr double pi = 3.14159265358979323846;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_inside(const Polygon& polygon, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const glm::dvec2 &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

glm::dvec3 placed(const glm::dvec2& p, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& origin) {
  return origin + p.x * u + p.y * v;
}

/// The polygon in a plane of its own, begun at each of some corners, in both turns.
void check_filled(const Polygon& polygon, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const glm::dvec3 u = glm::normalize(glm::dvec3(uniform(random), uniform(random), uniform(random) + 2.0));
  const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(uniform(random), 1.0, 0.0)));
  const glm::dvec3 origin(100.0 * uniform(random), 5.0, 7.0);
  glm::dvec2 lower = polygon[0], upper = polygon[0];
  for (const glm::dvec2& p : polygon) lower = glm::min(lower, p), upper = glm::max(upper, p);
  for (std::size_t run = 0; run < 4; ++run) {
    Polygon flat = polygon;
    std::rotate(flat.begin(), flat.begin() + static_cast<std::ptrdiff_t>(run * flat.size() / 4), flat.end());
    if (run % 2 == 1) std::reverse(flat.begin(), flat.end());
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& p : flat) corners.push_back(placed(p, u, v, origin));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    CAPTURE(polygon.size(), run);
    REQUIRE(triangulate(corners, triangles));
    REQUIRE(triangles.size() + 2 <= corners.size());
    // Newell's area by its own definition, corner by corner.
    double doubled = 0.0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const glm::dvec2 &a = flat[i], &b = flat[(i + 1) % flat.size()];
      doubled += a.x * b.y - a.y * b.x;
    }
    double sum = 0.0, absolute = 0.0;
    for (const auto& [a, b, c] : triangles) {
      const double area = turn(flat[a], flat[b], flat[c]);
      sum += area, absolute += std::abs(area);
    }
    CHECK(std::abs(sum - doubled) <= 1e-10 * std::abs(doubled));
    CHECK(std::abs(absolute - std::abs(doubled)) <= 1e-10 * std::abs(doubled));
    CHECK(std::abs(glm::length(newell_area(corners)) - std::abs(doubled)) <= 1e-10 * std::abs(doubled));
    for (int sample = 0; sample < 200; ++sample) {
      const glm::dvec2 p = lower + 0.5 * (glm::dvec2(uniform(random), uniform(random)) + 1.0) * (upper - lower);
      int covering = 0;
      for (const auto& [a, b, c] : triangles) covering += is_inside({flat[a], flat[b], flat[c]}, p) ? 1 : 0;
      CAPTURE(p.x, p.y);
      CHECK(covering == (is_inside(flat, p) ? 1 : 0));
    }
  }
}

Polygon star(int corners, double least, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(least, 1.0);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * pi * i / corners, r = radius(random);
    polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return polygon;
}

/// Out along one spiral and back along another.
Polygon spiral(int corners) {
  Polygon polygon;
  for (const double offset : {0.0, 0.4}) {
    for (int i = 0; i < corners; ++i) {
      const int k = offset > 0.0 ? corners - 1 - i : i;
      const double angle = 0.3 * k, r = 1.0 + 0.16 * angle + offset;
      polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }
  return polygon;
}

Polygon comb(int teeth) {
  Polygon polygon{{0.0, -1.0}};
  for (int i = 0; i < teeth; ++i) {
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.1, 5.0}, {0.5, 5.0}, {0.6, 0.0}}) polygon.emplace_back(i + x, y);
  }
  polygon.emplace_back(teeth, -1.0);
  return polygon;
}

}  // namespace

TEST_CASE("triangulate: concave faces of any number of corners are filled once, from whatever corner") {
  std::mt19937 random(19);
  for (const int corners : {3, 4, 5, 6, 7, 11, 40, 300}) {
    for (const double least : {0.02, 0.3, 0.99}) check_filled(star(corners, least, random), random);
  }
  for (int i = 0; i < 40; ++i) check_filled(star(4 + i % 4, 0.05, random), random);
  check_filled(spiral(60), random);
  check_filled(comb(20), random);
  check_filled({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, random);  // U
}

TEST_CASE("triangulate: corners on a line, twice the same, spikes, and outlines that go to holes and back") {
  std::mt19937 random(20);
  check_filled({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}, random);
  check_filled({{0, 0}, {1, 0}, {2, 0}, {2, 2}}, random);  // a triangle with a corner more
  check_filled({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}}, random);
  check_filled({{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}}, random);
  // One hole, then three: in from the outline, once around the hole against the turn, and back.
  check_filled({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}, random);
  Polygon sieve{{0, 0}, {10, 0}, {10, 4}, {0, 4}};
  for (const double x : {1.0, 4.0, 7.0}) {
    sieve.emplace_back(0, 0);
    for (const auto& [dx, dy] : {std::pair(0, 0), {1, 2}, {2, 1}, {0, 0}}) sieve.emplace_back(x + dx, 1 + dy);
  }
  check_filled(sieve, random);
  // Two squares that touch in a corner.
  check_filled({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, random);
}

TEST_CASE("triangulate: an outline that crosses itself is told, and lines are no faces") {
  const auto triangles_of = [](const Polygon& polygon, bool& simple) {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& p : polygon) corners.emplace_back(p, 3.0);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    simple = triangulate(corners, triangles);
    for (const auto& triangle : triangles) {
      for (const std::uint32_t corner : triangle) REQUIRE(corner < polygon.size());
    }
    return triangles.size();
  };
  bool simple = true;
  CHECK(triangles_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, simple) == 2);  // a bow tie, of equal halves
  CHECK(!simple);
  triangles_of({{0, 0}, {2, 2}, {2, 0}, {0, 1}}, simple);  // and of others
  CHECK(!simple);
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) pentagram.emplace_back(std::cos(4.0 * pi * i / 5.0), std::sin(4.0 * pi * i / 5.0));
  triangles_of(pentagram, simple);
  CHECK(!simple);
  triangles_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, simple);
  CHECK(simple);
  CHECK(triangles_of({{0, 0}, {1, 0}}, simple) == 0);
}
