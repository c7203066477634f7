// Lights far beyond what a scene should have: of any size against their distance, seen from their surface, flown by at
// 10^6 radii, thousands at one place; against long double.
#include <zonal/grid/add_lights.hpp>
#include <zonal/light/polygon.hpp>
#include <zonal/light/sphere.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "../catch.hpp"

namespace {

constexpr int N = 5;
constexpr double unit = 0x1p-24, pi = 3.14159265358979323846;

template <class T>
double largest(const zonal::Sh<N, T>& sh) {
  double most = 0;
  for (const T& value : sh) most = std::max(most, std::abs(double(value)));
  return most;
}
template <class T>
double largest_slope(const zonal::ShGradient<N, T>& sh) {
  return std::max({largest(sh.gradient[0]), largest(sh.gradient[1]), largest(sh.gradient[2])});
}

/// Errors of a sphere light in float, of the largest value and the largest slope; and the cap's cosine.
struct SphereErrors {
  double value = 0, slope = 0, cosine = 0;

  SphereErrors(const glm::vec3& centre, float radius, const glm::vec3& x) {
    const auto got = zonal::project_with_gradient<N>(zonal::SphereLight<float>{centre, radius}, x);
    using Wide = glm::vec<3, long double>;
    const zonal::SphereLight<long double> wide{Wide(centre), static_cast<long double>(radius)};
    const auto exact = zonal::project_with_gradient<N>(wide, Wide(x));
    const auto off = [](const zonal::Sh<N, float>& a, const zonal::Sh<N, long double>& b) {
      double most = 0;
      for (int i = 0; i < N * N; ++i) {
        most = std::max(most, double(std::abs(static_cast<long double>(a[i]) - b[i])));
      }
      return most;
    };
    value = off(got.value, exact.value) / largest(exact.value);
    for (int k = 0; k < 3; ++k) slope = std::max(slope, off(got.gradient[k], exact.gradient[k]));
    slope /= largest_slope(exact);
    const double s = double(radius) / double(glm::length(Wide(centre) - Wide(x)));
    cosine = s < 1 ? std::sqrt((1 - s) * (1 + s)) : 0;
  }
};

}  // namespace

TEST_CASE("stiff lights: a sphere of 1e-8 to 1 of its distance is as exact as its cosine can be") {
  std::mt19937 random(171);
  std::uniform_real_distribution<float> uniform(-1, 1);
  double worst_value = 0, worst_slope = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const float scale = std::pow(10.0F, 9 * uniform(random));  // 1e-9 to 1e9 units
    const float size =
        trial % 2 == 0 ? std::pow(10.0F, 4 * uniform(random) - 4) : 1 - std::pow(10.0F, 3 * uniform(random) - 3.5F);
    glm::vec3 direction(uniform(random), uniform(random), uniform(random));
    if (trial % 5 == 0) direction.x = direction.y = 0;  // at a pole
    direction = glm::normalize(direction);
    const glm::vec3 centre = scale * direction;
    const float radius = size * glm::length(centre);
    const SphereErrors errors(centre, radius, glm::vec3(0));
    // An ulp of the distance moves the cosine by that over itself.
    const double cosine = std::max(errors.cosine, std::sqrt(unit));
    CAPTURE(trial, scale, size, direction.x, direction.y, direction.z, errors.value, errors.slope, errors.cosine);
    if (errors.cosine < 4 * std::sqrt(unit)) continue;  // where the slope is cut off
    REQUIRE(errors.value <= 30 * unit + 4 * unit / cosine);
    REQUIRE(errors.slope <= 30 * unit + 4 * unit / (cosine * cosine));
    worst_value = std::max(worst_value, errors.value / (30 * unit + 4 * unit / cosine));
    worst_slope = std::max(worst_slope, errors.slope / (30 * unit + 4 * unit / (cosine * cosine)));
  }
  CAPTURE(worst_value, worst_slope);
  CHECK(worst_value > 0.125);  // not so far from what is seen
  CHECK(worst_slope > 0.125);
}

TEST_CASE("stiff lights: through a sphere's surface the value has no step, and the gradient a ceiling") {
  for (const float radius : {1e-6F, 1.0F, 3e7F}) {
    const zonal::SphereLight<float> light{{0, 0, 0}, radius};
    const glm::vec3 direction = glm::normalize(glm::vec3(0.3F, -0.5F, 0.8F));
    // The slope is 2 pi sin^2 a / (d cos a) P_l, where cos a counts as sqrt(epsilon) / 2 at least; Y_l^m up to
    // sqrt((2l+1)/4pi); what turns with the direction adds l A_l / d.
    const double ceiling = 2 * (4 * pi / std::sqrt(2 * unit) + 20) / double(radius);
    zonal::ShGradient<N, float> before;
    float at = 2.0F * radius, at_before = at;
    for (int step = 0; at > 0.25F * radius; ++step) {
      const auto sh = zonal::project_with_gradient<N>(light, at * direction);
      CAPTURE(radius, at / radius, step);
      REQUIRE(largest_slope(sh) <= ceiling);
      // From one place to the next no more than the gradients say, and what an ulp of the distance does to the cosine.
      if (step == 0) before = sh;
      const double steepest = std::sqrt(3.0) * std::max(largest_slope(sh), largest_slope(before));
      const double most = steepest * double(at_before - at) + std::sqrt(unit);
      for (int i = 0; i < N * N; ++i) REQUIRE(std::abs(double(sh.value[i]) - double(before.value[i])) <= most);
      before = sh, at_before = at;
      // Near the surface the steps are those of floats.
      const float gap = std::abs(at - radius) / radius;
      at = gap < 1e-5F ? std::nextafter(at, 0.0F) : at - std::min(2e-4F, 0.02F * gap) * radius;
    }
  }
}

TEST_CASE("stiff lights: a fly-by from 10^6 radii away and back") {
  for (const float beside : {0.5F, 1.0F, 1.001F, 3.0F}) {  // the nearest distance, in radii
    for (int side = -1; side <= 1; side += 2) {
      for (float along = 1e6F; along > 1e-6F; along *= 0.93F) {
        const glm::vec3 x(beside, 0, float(side) * along);
        const SphereErrors errors({0, 0, 0}, 1, x);
        CAPTURE(beside, x.z, errors.value, errors.slope, errors.cosine);
        const double cosine = std::max(errors.cosine, std::sqrt(unit));
        REQUIRE(errors.value <= 30 * unit + 4 * unit / cosine);
        if (errors.cosine > 4 * std::sqrt(unit)) REQUIRE(errors.slope <= 30 * unit + 4 * unit / (cosine * cosine));
      }
    }
  }
}

TEST_CASE("stiff lights: polygons of up to 1e9 times their distance") {
  const auto rule = zonal::gauss_legendre(64);
  std::mt19937 random(172);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    const float size = std::pow(10.0F, 9 * std::abs(uniform(random)));
    zonal::TriangleLight<float> light;
    for (int v = 0; v < 3; ++v) {  // about the point below the receiver
      const float angle = float(pi) * (2 * float(v) + 0.3F * uniform(random)) / 3;
      light.vertices[v] = {size * std::cos(angle), size * std::sin(angle), -1};
    }
    const auto got = zonal::project_with_gradient<N>(light, glm::vec3(0), 1e-7);
    zonal::PolygonLight<3, long double> wide;
    for (int v = 0; v < 3; ++v) wide.vertices[v] = glm::vec<3, long double>(light.vertices[v]);
    zonal::ShGradient<N, long double> exact;
    zonal::finish<N>(zonal::polygon_sums<N>(wide, rule, 0.0L, 0.0L, 0.0L), zonal::detail::into(exact));
    CAPTURE(trial, size);
    for (int i = 0; i < N * N; ++i) {
      REQUIRE(std::abs(double(got.value[i]) - double(exact.value[i])) <= 100 * unit);
    }
    REQUIRE(std::abs(double(got.value[0]) - std::sqrt(pi)) <= 10 / double(size) + 100 * unit);  // a hemisphere
  }
}

TEST_CASE("stiff lights: a hundred thousand at one place, and powers that span 1e12, are what their sum is") {
  using Light = zonal::ColouredLight<zonal::SphereLight<float>>;
  std::mt19937 random(173);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<Light> lights(100000);
  glm::dvec3 power(0);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const float strength = i < lights.size() / 2 ? std::pow(10.0F, 6 * uniform(random)) : 1 / 3.0F;
    lights[i] = {{{0.3F, 0.1F, 2}, 0.25F}, strength * glm::vec3(1, 0.5F, 0.1F)};
    power += glm::dvec3(lights[i].colour);
  }
  zonal::CoefficientGrid<2> grid({-1, -1, -1}, {1, 1, 1}, {2, 2, 2});
  zonal::add_lights(grid, lights, [](int count, const auto& body) {
    for (int i = 0; i < count; ++i) body(i);
  });
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 vertex(k & 1, k >> 1 & 1, k >> 2);
    using Wide = glm::dvec3;
    const zonal::SphereLight<double> one{Wide(lights[0].light.center), 0.25};
    const auto exact = zonal::project_with_gradient<2>(one, Wide(grid.position(vertex)));
    const auto got = grid.value_with_gradient(vertex);
    for (int i = 0; i < 4; ++i) {
      for (int c = 0; c < 3; ++c) {
        CAPTURE(k, i, c);
        // Each light by itself to 30 u, and the sum of 64 groups of four.
        REQUIRE(std::abs(double(got.value[i][c]) / power[c] - exact.value[i]) <= (30 + 258) * unit * exact.value[0]);
      }
    }
  }
}
