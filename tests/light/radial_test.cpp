// Lights that are symmetric about the direction to their centre: value and gradient.
#include <zonal/light/point.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/lobe/spherical_gaussian.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/packet.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "../catch.hpp"
#include "../csv.hpp"
#include "added_light.hpp"

namespace {

constexpr int N = 8;

template <class T>
using Vec = glm::vec<3, T>;

/// The greatest error of value and gradient, each against the largest of its degree in the same row of the table.
template <class T>
std::pair<double, double> error_against_table() {
  const auto rows = read_csv("sphere_light.csv");
  const auto place = [](const std::vector<double>& row) { return std::vector<double>(row.begin(), row.begin() + 8); };
  std::map<std::vector<double>, std::pair<double, double>> largest;  // of this place and degree
  for (const auto& row : rows) {
    auto& unit = largest[place(row)];
    unit.first = std::max(unit.first, std::abs(row[9]));
    for (std::size_t k = 10; k < 13; ++k) unit.second = std::max(unit.second, std::abs(row[k]));
  }
  std::pair<double, double> worst;
  for (const auto& row : rows) {
    const auto t = [&](std::size_t i) { return static_cast<T>(row[i]); };
    const zonal::SphereLight<T> light{{t(3), t(4), t(5)}, t(6)};
    const auto sh = zonal::project_with_gradient<10>(light, Vec<T>(t(0), t(1), t(2)));
    const int l = static_cast<int>(row[7]), m = static_cast<int>(row[8]);
    const auto unit = largest[place(row)];
    worst.first = std::max(worst.first, std::abs(static_cast<double>(sh.value(l, m)) - row[9]) / unit.first);
    for (int k = 0; k < 3; ++k) {
      const double exact = row[static_cast<std::size_t>(10 + k)];
      worst.second = std::max(worst.second, std::abs(static_cast<double>(sh.gradient[k](l, m)) - exact) / unit.second);
    }
  }
  return worst;
}

/// Value and gradient in T against dual numbers, at receivers of a fixed seed and those given.
template <class MakeLight>
void check_against_dual(const char* name, MakeLight make, std::vector<Vec<double>> receivers,
                        double tolerance = 1e-12) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int i = 0; i < 100; ++i) receivers.push_back({uniform(random), uniform(random), uniform(random)});
  using D = zonal::Dual<double, 3>;
  const auto light = make(double());
  for (const auto& x : receivers) {
    const auto got = zonal::project_with_gradient<N>(light, x);
    const auto value = zonal::project<N>(light, x);
    zonal::Sh<N, D> dual{};
    zonal::project<N>(light, D::variable(x[0], 0), D::variable(x[1], 1), D::variable(x[2], 2),
                      [&](auto l, auto m, const D& y) { dual(l, m) = y; });
    double unit = 0, slope_unit = 0;
    for (const D& y : dual) {
      unit = std::max(unit, std::abs(y.value));
      for (const double d : y.partial) slope_unit = std::max(slope_unit, std::abs(d));
    }
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(name, x[0], x[1], x[2], i, unit, slope_unit);
      REQUIRE(std::abs(got.value[i] - dual[i].value) <= tolerance * unit);
      REQUIRE(std::abs(value[i] - dual[i].value) <= tolerance * unit);
      for (int k = 0; k < 3; ++k) {
        REQUIRE(std::abs(got.gradient[k][i] - dual[i].partial[static_cast<std::size_t>(k)]) <= tolerance * slope_unit);
      }
    }
  }
}

/// The gradient in long double against central differences of the value.
template <class Light>
void check_against_differences(const char* name, const Light& light) {
  std::mt19937 random(42);
  std::uniform_real_distribution<long double> uniform(-2, 2);
  for (int trial = 0; trial < 60; ++trial) {
    const Vec<long double> x(uniform(random), uniform(random), uniform(random));
    const auto got = zonal::project_with_gradient<N>(light, x);
    for (int k = 0; k < 3; ++k) {
      const long double h = 1e-6L;
      Vec<long double> above = x, below = x;
      above[k] += h, below[k] -= h;
      const auto high = zonal::project<N>(light, above), low = zonal::project<N>(light, below);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(name, static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]), k, i);
        REQUIRE(std::abs(static_cast<double>(got.gradient[k][i] - (high[i] - low[i]) / (2 * h))) <= 1e-8);
      }
    }
  }
}

const std::vector<Vec<double>> above_and_beside{{0, 0, 5}, {0, 0, -5}, {1e-9, 0, 5}, {3, 1e-14, -3}};

}  // namespace

TEST_CASE("sphere light: meets the reference table") {
  const auto wide = error_against_table<double>(), narrow = error_against_table<float>();
  CAPTURE(wide.first, wide.second, narrow.first, narrow.second);
  CHECK(std::max(wide.first, wide.second) <= 1e-14);
  CHECK(std::max(narrow.first, narrow.second) <= 5e-6);
}

TEST_CASE("lights: value and gradient are those of dual numbers, in line with the axes too") {
  check_against_dual(
      "sphere",
      [](auto t) {
        return zonal::SphereLight<decltype(t)>{{0, 0, 0}, 0.3};
      },
      above_and_beside, 1e-11);
  check_against_dual(
      "soft sphere",
      [](auto t) {
        using T = decltype(t);
        return zonal::SoftSphereLight<N, T>{{0, 0, 0}, 0.3, zonal::project<N>(zonal::SphericalGaussian<T>{20})};
      },
      above_and_beside, 1e-11);
  check_against_dual(
      "point",
      [](auto t) {
        return zonal::PointLight<decltype(t)>{{0, 0, 0}};
      },
      above_and_beside);
  check_against_dual(
      "spot",
      [](auto t) {
        return zonal::SpotLight<decltype(t)>{{0, 0, 0}, {0.6, 0, 0.8}, 0.9, -0.5};
      },
      above_and_beside);
  check_against_dual(
      "lantern",
      [](auto) {
        return Lantern{{0, 0, 0}, 0.3, 1.5, true};
      },
      above_and_beside, 1e-11);
}

namespace {

/// Requires value and gradient of a light to be finite at x, and returns them.
template <int Bands, class T, class Light>
zonal::ShGradient<Bands, T> finite(const Light& light, const Vec<T>& x) {
  const auto sh = zonal::project_with_gradient<Bands>(light, x);
  for (int i = 0; i < Bands * Bands; ++i) {
    CAPTURE(x[0], x[1], x[2], i, sh.value[i], sh.gradient[0][i], sh.gradient[1][i], sh.gradient[2][i]);
    REQUIRE(std::isfinite(sh.value[i]));
    for (const auto& gradient : sh.gradient) REQUIRE(std::isfinite(gradient[i]));
  }
  return sh;
}

template <class T>
void check_finite(const std::vector<T>& lengths) {
  constexpr int bands = 4;
  for (const T distance : lengths) {
    for (const Vec<T>& x : {Vec<T>(distance, 0, 0), Vec<T>(0, -distance, distance), Vec<T>(distance)}) {
      for (const T radius : lengths) {
        finite<bands>(zonal::SphereLight<T>{{0, 0, 0}, radius}, x);
        finite<bands>(zonal::SoftSphereLight<bands, T>{{0, 0, 0}, radius, {{1, T(0.5), 0, -1}}}, x);
      }
      finite<bands>(zonal::PointLight<T>{-x}, x);
      for (const T inner : {T(-1), T(0), T(0.5), T(1)}) {
        for (const T outer : {T(-1), T(0), T(1e-30), T(0.5), T(1)}) {  // in the wrong order too
          finite<bands>(zonal::SpotLight<T>{{0, 0, 0}, {T(0.6), 0, T(0.8)}, inner, outer}, x);
          finite<bands>(zonal::SpotLight<T>{{0, 0, 0}, {-1, 0, 0}, inner, outer}, x);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("lights: from finite numbers finite ones, at a light, without extent, at any distance") {
  check_finite<float>({0, 1e-45F, 1e-30F, 1e-20F, 1e-12F, 3e-10F, 1e-4F, 1, 1e6F, 1e15F, 1e19F, 1e30F, 3e38F});
  check_finite<double>({0, 5e-324, 1e-200, 1e-80, 1e-77, 1e-12, 1, 1e15, 1e100, 1e154, 1e200, 1e308});
}

TEST_CASE("lights: at their own place in a packet, finite and the same as alone") {
  using Lanes = zonal::Packet<float, zonal::kNativeLanes>;
  const zonal::PointLight<float> light{{1, 2, 3}};
  Lanes x(1), y(2), z(3);
  x.set(1, 1.25F), y.set(2, 1e30F), z.set(3, -3e38F);
  const float lanes[4][3] = {{1, 2, 3}, {1.25F, 2, 3}, {1, 1e30F, 3}, {1, 2, -3e38F}};
  zonal::project_with_gradient<3>(
      light, x, y, z, [&](auto l, auto m, const Lanes& value, const Lanes& gx, const Lanes& gy, const Lanes& gz) {
        for (int lane = 0; lane < 4; ++lane) {
          const auto alone = finite<3>(light, glm::vec3(lanes[lane][0], lanes[lane][1], lanes[lane][2]));
          const auto near = [](float a) { return Catch::Approx(a).epsilon(1e-5).margin(1e-30); };
          CAPTURE(lane);
          CHECK(value[lane] == near(alone.value(l, m)));
          CHECK(gx[lane] == near(alone.gradient[0](l, m)));
          CHECK(gy[lane] == near(alone.gradient[1](l, m)));
          CHECK(gz[lane] == near(alone.gradient[2](l, m)));
        }
      });
}

TEST_CASE("spot light: of equal cones it is hard: a point light inside, nothing outside") {
  const auto spot = [](float cosine) { return zonal::SpotLight<float>{{0, 0, 2}, {0, 0, -1}, cosine, cosine}; };
  const auto check = [&](float cosine, const glm::vec3& x, bool is_inside) {
    const auto got = finite<3>(spot(cosine), x);
    const auto point = zonal::project_with_gradient<3>(zonal::PointLight<float>{{0, 0, 2}}, x);
    for (int i = 0; i < 9; ++i) {
      CAPTURE(cosine, x.x, x.z, i);
      CHECK(got.value[i] == Catch::Approx(is_inside ? point.value[i] : 0.0F).margin(1e-7));
      for (int k = 0; k < 3; ++k) {
        CHECK(got.gradient[k][i] == Catch::Approx(is_inside ? point.gradient[k][i] : 0.0F).margin(1e-7));
      }
    }
  };
  check(0.9F, {0, 0, 0}, true);
  check(0.9F, {0.9F, 0, 0}, true);  // cosine 0.912
  check(0.9F, {1, 0, 0}, false);    // 0.894
  check(0.9F, {0, 0, 5}, false);
  for (const glm::vec3& x : {glm::vec3(0, 0, 0), glm::vec3(0.1F, 0.3F, 4), glm::vec3(0, 0, 5)}) check(-1, x, true);
  check(1, {0, 0, 0}, true);  // on the axis itself
  check(1, {0.1F, 0, 0}, false);
  check(0, {3, 0, 1.9F}, true);
  check(0, {3, 0, 2.1F}, false);
}

TEST_CASE("lights: the gradient is that of central differences in long double") {
  check_against_differences("sphere", zonal::SphereLight<long double>{{2.5L, 0, 0.3L}, 0.4L});
  check_against_differences("point", zonal::PointLight<long double>{{2.5L, 0, 0.3L}});
  check_against_differences("spot", zonal::SpotLight<long double>{{3, 0, 0}, {-1, 0, 0}, 0.95L, 0.3L});
}

TEST_CASE("sphere light: inside it is a hemisphere, on it finite, at its centre finite") {
  const zonal::SphereLight<float> light{{1, 2, 3}, 2};
  const auto hemisphere = zonal::project<N>(zonal::SphericalCap<float>{0, 1});
  const auto inside = zonal::project_with_gradient<N>(light, glm::vec3(1, 2, 2));  // the centre is at +z, distance 1
  for (int l = 0; l < N; ++l) CHECK(inside.value(l, 0) == Catch::Approx(hemisphere[l]).margin(1e-6));
  // Along the direction to the centre nothing changes; across, the hemisphere turns by 1 / distance per length.
  for (const float g : inside.gradient[2]) CHECK(std::abs(g) <= 1e-5F);
  const auto turned = zonal::project<N>(light, glm::vec3(1.001F, 2, 2));
  const auto back = zonal::project<N>(light, glm::vec3(0.999F, 2, 2));
  for (int i = 0; i < N * N; ++i) {
    CHECK(std::abs(inside.gradient[0][i] - (turned[i] - back[i]) / 0.002F) <= 2e-3F);
  }

  for (const glm::vec3& x : {glm::vec3(1, 2, 1), glm::vec3(1, 2, 3), glm::vec3(1, 2, 3.0000002F)}) {
    const auto sh = zonal::project_with_gradient<N>(light, x);
    CAPTURE(x.z);
    for (int i = 0; i < N * N; ++i) {
      CHECK(std::abs(sh.value[i]) <= 3);
      for (const auto& gradient : sh.gradient) CHECK(std::isfinite(gradient[i]));
    }
  }
  const auto centre = zonal::project<N>(light, glm::vec3(1, 2, 3));
  for (int l = 0; l < N; ++l) CHECK(centre(l, 0) == Catch::Approx(hemisphere[l]).margin(1e-6));
}

TEST_CASE("soft sphere: a kernel that does nothing leaves the sphere, a wide one leaves the mean") {
  const zonal::SphereLight<double> sharp{{1, 2, 2}, 1};
  zonal::Zh<N, double> delta{}, mean{};
  for (int l = 0; l < N; ++l) delta[l] = std::sqrt((2 * l + 1) / (4 * 3.14159265358979323846));
  mean[0] = delta[0];
  const glm::dvec3 x(0, 0, 0);
  const auto expected = zonal::project_with_gradient<N>(sharp, x);
  const auto same = zonal::project_with_gradient<N>(zonal::SoftSphereLight<N, double>{{1, 2, 2}, 1, delta}, x);
  const auto flat = zonal::project_with_gradient<N>(zonal::SoftSphereLight<N, double>{{1, 2, 2}, 1, mean}, x);
  for (int i = 0; i < N * N; ++i) {
    CHECK(std::abs(same.value[i] - expected.value[i]) <= 1e-14);
    CHECK(std::abs(same.gradient[1][i] - expected.gradient[1][i]) <= 1e-14);
    CHECK(std::abs(flat.value[i] - (i == 0 ? expected.value[i] : 0)) <= 1e-14);
  }
}

TEST_CASE("point, spot and directional lights: a distant small sphere, a cone, and a constant") {
  // A sphere of radius r and radiance 1 far away has the intensity pi r^2.
  const glm::dvec3 x(0.1, 0.2, 0.3), center(30, 20, -10);
  const auto sphere = zonal::project<N>(zonal::SphereLight<double>{center, 1e-4}, x);
  const auto point = zonal::project<N>(zonal::PointLight<double>{center}, x);
  for (int i = 0; i < N * N; ++i) {
    CHECK(sphere[i] == Catch::Approx(3.14159265358979323846 * 1e-8 * point[i]).epsilon(1e-6).margin(1e-16));
  }
  const auto intensity = [&](double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180;
    return zonal::project<1>(zonal::SpotLight<double>{{0, 0, 0}, {0, 0, 1}, std::cos(0.5), std::cos(1.0)},
                             glm::dvec3(std::sin(a), 0, std::cos(a)))[0];
  };
  const double full = zonal::evaluate<1>(glm::dvec3(0, 0, 1))[0];
  CHECK(intensity(10) == Catch::Approx(full));
  CHECK(intensity(28) == Catch::Approx(full));
  CHECK(intensity(58) == 0);
  CHECK(intensity(180) == 0);
  const double middle = std::acos((std::cos(0.5) + std::cos(1.0)) / 2) * 180 / 3.14159265358979323846;
  CHECK(intensity(middle) == Catch::Approx(full / 2));

  const zonal::DirectionalLight<double> sun{{0, 0.6, 0.8}};
  const auto sh = zonal::project_with_gradient<N>(sun, x);
  const auto expected = zonal::evaluate<N>(sun.direction);
  for (int i = 0; i < N * N; ++i) {
    CHECK(sh.value[i] == expected[i]);
    for (const auto& gradient : sh.gradient) CHECK(gradient[i] == 0);
  }
}
