// Polygon lights: against quadrature over their surface, dual numbers, differences; and where they degenerate.
#include <zonal/light/triangle.hpp>
#include <zonal/lobe/cap.hpp>
#include <zonal/scalar/dual.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "../catch.hpp"

namespace {

constexpr int N = 9;
constexpr double pi = 3.14159265358979323846;

/// By definition: the basis over the triangle's surface, solid angle by solid angle.
zonal::Sh<N, double> by_quadrature(const zonal::TriangleLight<double>& light, const glm::dvec3& x, int nodes = 60) {
  const auto rule = zonal::gauss_legendre(nodes);
  const glm::dvec3 a = light.vertices[0], ab = light.vertices[1] - a, bc = light.vertices[2] - light.vertices[1];
  const glm::dvec3 area = glm::cross(ab, bc);
  zonal::Sh<N, double> sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double u = (1 + rule.nodes[i]) / 2, v = (1 + rule.nodes[j]) / 2;
      const glm::dvec3 p = a + ab * u + bc * (u * v) - x;
      const double distance = glm::length(p);
      const double solid_angle = std::abs(glm::dot(area, p)) / (distance * distance * distance);
      sum += zonal::evaluate<N>(p / distance) * (rule.weights[i] * rule.weights[j] / 4 * u * solid_angle);
    }
  }
  return sum;
}

template <class Array>
double largest(const Array& values) {
  double result = 0;
  for (const auto& value : values) result = std::max(result, std::abs(static_cast<double>(value)));
  return result;
}

struct Random {
  std::mt19937 engine{51};
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  glm::dvec3 point(double low, double high) { return {(*this)(low, high), (*this)(low, high), (*this)(low, high)}; }
  zonal::TriangleLight<double> triangle(double size) {
    return {{glm::dvec3(0, 0, 2) + point(-size, size), glm::dvec3(0, 0, 2) + point(-size, size),
             glm::dvec3(0, 0, 2) + point(-size, size)}};
  }
};

template <int V, class To, class From>
zonal::PolygonLight<V, To> cast(const zonal::PolygonLight<V, From>& light) {
  zonal::PolygonLight<V, To> result;
  for (int v = 0; v < V; ++v) result.vertices[v] = glm::vec<3, To>(light.vertices[v]);
  return result;
}

}  // namespace

TEST_CASE("polygon: is the integral over its surface, to the tolerance asked for") {
  Random random;
  for (int trial = 0; trial < 60; ++trial) {
    const auto light = random.triangle(std::pow(10.0, -2 * (trial % 5) / 4.0));
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto expected = by_quadrature(light, x);
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const auto got = zonal::project<N>(light, x, tolerance);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(trial, tolerance, i, got[i], expected[i]);
        REQUIRE(std::abs(got[i] - expected[i]) <= 2 * tolerance * largest(expected) + 1e-11 * largest(expected));
      }
    }
  }
}

TEST_CASE("polygon: the gradient is that of dual numbers, and of differences in long double") {
  Random random;
  const auto rule = zonal::gauss_legendre(24);
  using D = zonal::Dual<double, 3>;
  for (int trial = 0; trial < 30; ++trial) {
    const auto light = random.triangle(1);
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto got = zonal::project_with_gradient<N>(light, x, 1e-12);
    zonal::Sh<N, D> dual{};
    zonal::finish<N>(
        zonal::polygon_sums<N>(light, rule, D::variable(x[0], 0), D::variable(x[1], 1), D::variable(x[2], 2)),
        [&](auto l, auto m, const D& value, const D&, const D&, const D&) { dual(l, m) = value; });
    const auto wide = cast<3, long double>(light);
    for (int k = 0; k < 3; ++k) {
      glm::vec<3, long double> above(x), below(x);
      const long double h = 1e-6L;
      above[k] += h, below[k] -= h;
      const auto high = zonal::project<N>(wide, above, 1e-14), low = zonal::project<N>(wide, below, 1e-14);
      const double unit = largest(got.gradient[0]) + largest(got.gradient[1]) + largest(got.gradient[2]);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(trial, k, i);
        REQUIRE(std::abs(got.gradient[k][i] - dual[i].partial[static_cast<std::size_t>(k)]) <= 1e-9 * unit);
        const double slope = static_cast<double>((high[i] - low[i]) / (2 * h));
        REQUIRE(std::abs(got.gradient[k][i] - slope) <= 1e-7 * unit);
      }
    }
  }
}

TEST_CASE("polygon: in float, 2e-6 over the angular size") {
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    const double size = std::pow(10.0, -2 * (trial % 5) / 4.0);
    const glm::dvec3 x = random.point(-0.6, 0.6), corner = glm::dvec3(0, 0, 2) + random.point(-0.5, 0.5);
    const glm::dvec3 across(size, random(-0.3, 0.3) * size, 0), up(0, size, random(-0.5, 0.5) * size);
    const zonal::PolygonLight<4, double> light{{corner, corner + across, corner + across + up, corner + up}};
    const auto narrow_light = cast<4, float>(light);
    const auto narrow = zonal::project_with_gradient<N>(narrow_light, glm::vec3(x), 1e-7);
    const auto wide = zonal::project_with_gradient<N>(cast<4, double>(narrow_light), glm::dvec3(glm::vec3(x)), 1e-9);
    const double bound = 4e-6 / size,
                 unit = largest(wide.gradient[0]) + largest(wide.gradient[1]) + largest(wide.gradient[2]);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(trial, size, i);
      REQUIRE(std::abs(static_cast<double>(narrow.value[i]) - wide.value[i]) <= bound * largest(wide.value));
      for (int k = 0; k < 3; ++k) {
        REQUIRE(std::abs(static_cast<double>(narrow.gradient[k][i]) - wide.gradient[k][i]) <= bound * unit);
      }
    }
  }
}

TEST_CASE("polygon: a quadrilateral is its two triangles, from any side and either way around") {
  const zonal::PolygonLight<4, double> square{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  const zonal::PolygonLight<4, double> turned{{{-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {-1, -1, 2}}};
  const zonal::TriangleLight<double> one{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}}},
      two{{{-1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  for (const glm::dvec3& x : {glm::dvec3(0.3, 0.2, 0), glm::dvec3(0.1, 3, 5), glm::dvec3(-4, 0, 1.9)}) {
    const auto whole = zonal::project_with_gradient<N>(square, x, 1e-10),
               back = zonal::project_with_gradient<N>(turned, x, 1e-10);
    const auto a = zonal::project_with_gradient<N>(one, x, 1e-10), b = zonal::project_with_gradient<N>(two, x, 1e-10);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(x.x, x.y, x.z, i);
      CHECK(std::abs(whole.value[i] - a.value[i] - b.value[i]) <= 1e-9);
      CHECK(std::abs(whole.value[i] - back.value[i]) <= 1e-12);
      for (int k = 0; k < 3; ++k) {
        CHECK(std::abs(whole.gradient[k][i] - a.gradient[k][i] - b.gradient[k][i]) <= 1e-8);
        CHECK(std::abs(whole.gradient[k][i] - back.gradient[k][i]) <= 1e-12);
      }
    }
  }
}

TEST_CASE("polygon: a hemisphere when it fills one, and a sphere's cap when it is round") {
  const zonal::PolygonLight<4, double> wall{{{-1e5, -1e5, 1}, {1e5, -1e5, 1}, {1e5, 1e5, 1}, {-1e5, 1e5, 1}}};
  const auto hemisphere = zonal::project<N>(zonal::SphericalCap<double>{0, 1});
  const auto sh = zonal::project<N>(wall, glm::dvec3(0, 0, 0), 1e-8);
  for (int l = 0; l < N; ++l) CHECK(std::abs(sh(l, 0) - hemisphere[l]) <= 1e-3);

  constexpr int sides = 96;
  zonal::PolygonLight<sides, double> disc;
  for (int v = 0; v < sides; ++v) {
    disc.vertices[v] = glm::dvec3(std::cos(2 * pi * v / sides), std::sin(2 * pi * v / sides), 2);
  }
  const auto round = zonal::project<N>(disc, glm::dvec3(0, 0, 0), 1e-8);
  const auto cap = zonal::project<N>(zonal::SphericalCap<double>::from_angle(std::atan(0.5)));
  for (int l = 0; l < N; ++l) CHECK(std::abs(round(l, 0) - cap[l]) <= 2e-3 * cap[1]);
}

TEST_CASE("polygon: in its plane zero; on the surface a hemisphere; on an edge and at a vertex finite") {
  const zonal::TriangleLight<float> light{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  const auto beside = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1));
  const auto above = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1 + 1e-3F));
  const auto below = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1 - 1e-3F));
  CHECK(largest(beside.value) <= 1e-6);
  CHECK(largest(beside.gradient[2]) > 1e-3);
  for (int i = 0; i < N * N; ++i) CHECK(std::abs(above.value[i]) <= 1e-3F);
  CHECK(largest(below.value) > 1e-6);

  const auto hemisphere = zonal::project<N>(zonal::SphericalCap<float>{0, 1});
  const auto near = zonal::project<N>(light, glm::vec3(0.3F, 0.3F, 1 - 1e-4F));
  for (int l = 0; l < N; ++l) CHECK(std::abs(near(l, 0) - hemisphere[l]) <= 5e-3F);

  for (const glm::vec3& x : {glm::vec3(0, 0, 1), glm::vec3(0.5F, 0, 1), glm::vec3(0.25F, 0.75F, 1),
                             glm::vec3(0.3F, 0.3F, 1), glm::vec3(-1, 0, 1), glm::vec3(0.5F, 1e-20F, 1)}) {
    const auto sh = zonal::project_with_gradient<N>(light, x);
    CAPTURE(x.x, x.y, x.z);
    for (int i = 0; i < N * N; ++i) {
      CHECK(std::isfinite(sh.value[i]));
      CHECK(std::abs(sh.value[i]) <= 10);
      for (const auto& gradient : sh.gradient) CHECK(std::isfinite(gradient[i]));
    }
  }
  const zonal::TriangleLight<float> flat{{{0, 0, 1}, {0, 0, 1}, {1, 0, 1}}};  // no area
  CHECK(largest(zonal::project<N>(flat, glm::vec3(0.2F, 0.3F, 0))) <= 1e-6);
}

TEST_CASE("triangle as a sphere: near the exact one when small, and its gradient is that of dual numbers") {
  Random random;
  using D = zonal::Dual<double, 3>;
  for (int trial = 0; trial < 50; ++trial) {
    const auto light = random.triangle(0.03);
    const auto sphere = zonal::TriangleSphereLight<double>::approximate(light);
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto exact = zonal::project<N>(light, x), approximate = zonal::project<N>(sphere, x);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(trial, i);
      CHECK(std::abs(exact[i] - approximate[i]) <= 0.02 * largest(exact));
    }

    const auto got = zonal::project_with_gradient<N>(sphere, x);
    zonal::Sh<N, D> dual{};
    zonal::project<N>(sphere, D::variable(x[0], 0), D::variable(x[1], 1), D::variable(x[2], 2),
                      [&](auto l, auto m, const D& y) { dual(l, m) = y; });
    for (int i = 0; i < N * N; ++i) {
      for (int k = 0; k < 3; ++k) {
        CHECK(std::abs(got.gradient[k][i] - dual[i].partial[static_cast<std::size_t>(k)]) <= 1e-11);
      }
    }
  }
}
