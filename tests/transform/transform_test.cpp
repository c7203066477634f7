#include <zonal/zonal.hpp>

#include <array>
#include <cmath>
#include <random>

#include "../catch.hpp"

namespace {

using Vec3 = std::array<double, 3>;

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Vec3 v{normal(random), normal(random), normal(random)};
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The integral over the sphere of f(direction) Y, by the midpoint rule in cos theta and phi.
template <int N, class F>
zonal::Sh<N, double> project_by_quadrature(F f, int rows, int columns) {
  zonal::Sh<N, double> sum{};
  const double pi = static_cast<double>(zonal::kPi);
  for (int i = 0; i < rows; ++i) {
    const double z = -1 + 2 * (i + 0.5) / rows, r = std::sqrt(1 - z * z);
    for (int j = 0; j < columns; ++j) {
      const double phi = 2 * pi * (j + 0.5) / columns;
      const Vec3 d{r * std::cos(phi), r * std::sin(phi), z};
      sum += zonal::evaluate<N>(d) * (f(d) * 4 * pi / (rows * columns));
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("orient: a lobe turned by SLS05 is the projection of the turned lobe") {
  std::mt19937 random(7);
  const auto zh = zonal::project<6>(zonal::SphericalGaussian<double>{6.0});
  for (int trial = 0; trial < 4; ++trial) {
    const Vec3 axis = random_direction(random);
    const auto turned = zonal::orient(zh, axis);
    const auto expected =
        project_by_quadrature<6>([&](const Vec3& d) { return std::exp(6.0 * (dot(d, axis) - 1)); }, 1500, 64);
    for (int i = 0; i < 36; ++i) {
      CAPTURE(axis[0], axis[1], axis[2], i);
      CHECK(std::abs(turned[i] - expected[i]) < 2e-6);
    }
  }
}

TEST_CASE("orient: to the z axis gives the zonal coefficients back") {
  const auto zh = zonal::project<8>(zonal::PhongLobe<double>{5.0});
  const auto sh = zonal::orient(zh, Vec3{0, 0, 1});
  for (int l = 0; l < 8; ++l) {
    for (int m = -l; m <= l; ++m) CHECK(std::abs(sh(l, m) - (m == 0 ? zh[l] : 0)) < 1e-15);
  }
}

TEST_CASE("dot: the integral of the product of two oriented lobes, two ways") {
  std::mt19937 random(8);
  const auto a = zonal::project<9>(zonal::SphericalCap<double>::from_angle(0.7));
  const auto b = zonal::project<9>(zonal::PhongLobe<double>{9.0});
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 u = random_direction(random), v = random_direction(random);
    const double full = zonal::dot(zonal::orient(a, u), zonal::orient(b, v));
    const double zonal_only = zonal::reconstruct_zonal(zonal::convolve(a, b), dot(u, v));
    CAPTURE(u[0], u[1], u[2], v[0], v[1], v[2]);
    CHECK(std::abs(full - zonal_only) < 1e-14);
  }
}

TEST_CASE("convolve: irradiance over pi of a light is its integral against the clamped cosine") {
  std::mt19937 random(9);
  const double pi = static_cast<double>(zonal::kPi);
  const Vec3 axis = random_direction(random), normal = random_direction(random);
  const auto light = zonal::orient(zonal::project<5>(zonal::SphericalCap<double>::from_angle(0.5)), axis);
  const auto lambert = zonal::project<5, double>(zonal::LambertLobe{});
  const double by_convolution = zonal::reconstruct(zonal::convolve(light, lambert), normal);
  const auto cosine =
      project_by_quadrature<5>([&](const Vec3& d) { return std::max(dot(d, normal), 0.0) / pi; }, 1500, 512);
  CHECK(std::abs(by_convolution - zonal::dot(light, cosine)) < 2e-6);
}

TEST_CASE("reconstruct: is evaluate and dot in one") {
  std::mt19937 random(10);
  zonal::Sh<10, double> sh{};
  for (double& c : sh) c = std::normal_distribution<double>()(random);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 d = random_direction(random);
    CHECK(std::abs(zonal::reconstruct(sh, d) - zonal::dot(sh, zonal::evaluate<10>(d))) < 1e-13);
  }
}

TEST_CASE("reconstruct_convolved: is convolve and reconstruct in one") {
  std::mt19937 random(12);
  zonal::Sh<6, double> sh{};
  for (double& c : sh) c = std::normal_distribution<double>()(random);
  const auto kernel = zonal::project<6>(zonal::PhongLobe<double>{7});
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 d = random_direction(random);
    CHECK(std::abs(zonal::reconstruct_convolved(sh, kernel, d) - zonal::reconstruct(zonal::convolve(sh, kernel), d)) <
          1e-13);
  }
}

TEST_CASE("window: factors by their formulas, zero at the width, and the mean kept") {
  zonal::Sh<5, double> ones{};
  for (double& c : ones) c = 1;
  const double pi = static_cast<double>(zonal::kPi);
  const auto hann = zonal::apply_window(ones, zonal::Window::hann);
  const auto sinc = zonal::apply_window(ones, zonal::Window::sinc);
  for (int l = 0; l < 5; ++l) {
    for (int m = -l; m <= l; ++m) {
      CHECK(std::abs(hann(l, m) - (1 + std::cos(pi * l / 5)) / 2) < 1e-15);
      CHECK(std::abs(sinc(l, m) - (l == 0 ? 1 : std::sin(pi * l / 5) / (pi * l / 5))) < 1e-15);
    }
  }
  CHECK(std::abs(zonal::window_factor(zonal::Window::hann, 5, 5)) < 1e-15);
  CHECK(std::abs(zonal::window_factor(zonal::Window::sinc, 5, 5)) < 1e-15);
  CHECK(zonal::apply_window(ones, zonal::Window::none)(4, 2) == 1);
}

TEST_CASE("window: zero from the width on, degree 0 as it is, whatever the width") {
  zonal::Sh<6, double> ones{};
  for (double& c : ones) c = 1;
  for (const double width : {0.5, 1.0, 2.0, 3.5, 5.9, 0.0, -1.0, std::nan("")}) {
    for (const auto kind : {zonal::Window::hann, zonal::Window::sinc}) {
      const auto windowed = zonal::apply_window(ones, kind, width);
      double before = 1;
      for (int l = 0; l < 6; ++l) {
        CAPTURE(width, l);
        if (l > 0 && !(l < width)) CHECK(windowed(l, 0) == 0);
        CHECK(windowed(l, l) <= before);
        CHECK(windowed(l, l) >= 0);
        before = windowed(l, l);
      }
      CHECK(windowed[0] == 1);
    }
  }
}
