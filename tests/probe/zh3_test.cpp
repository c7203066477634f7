// ZH3 and non-linear L1 against integrals, and the authors' formulas as they print them.
#include <zonal/environment/irradiance.hpp>
#include <zonal/environment/rgb.hpp>
#include <zonal/probe/nonlinear_l1.hpp>
#include <zonal/probe/zh3.hpp>
#include <zonal/transform/rotate.hpp>

#include <array>
#include <cmath>
#include <cstddef>

#include "../catch.hpp"
#include "probes.hpp"

namespace {

using probes::pi;
using probes::Vec3;
using zonal::Sh;
using zonal::Zh3;
using zonal::Zh3Axis;
using Rgb = zonal::Rgb<double>;

Vec3 axis_of(const Sh<2, double>& linear) {
  double axis[3];
  zonal::linear_axis(linear, axis);
  return {axis[0], axis[1], axis[2]};
}
Sh<3, Rgb> colours(probes::Random& random, double size) {
  Sh<3, Rgb> sh{};
  for (int c = 0; c < 3; ++c) {
    const auto f = random.function<3>(size);
    for (int i = 0; i < 9; ++i) sh[i][c] = f[i] * (1 + c);
  }
  return sh;
}
// The squared error of E / pi of all channels, by coefficients: these are orthonormal.
double squared_error(const Sh<3, Rgb>& sh, const Zh3<Rgb>& zh3, Zh3Axis kind) {
  const Sh<3, Rgb> difference = zonal::irradiance_over_pi(sh - zonal::expand(zh3, kind));
  double sum = 0;
  for (const Rgb& c : difference) sum += c.r * c.r + c.g * c.g + c.b * c.b;
  return sum;
}

}  // namespace

TEST_CASE("probe: ZH3's zonal coefficient is the projection about the axis") {
  probes::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const auto f = random.function<3>(0.5);
    const Zh3<double> zh3 = zonal::project_zh3(f);
    const Vec3 axis = axis_of(zh3.linear);
    const auto y2 = [&](const Vec3& d) {
      return std::sqrt(5 / (16 * pi)) * (3 * std::pow(probes::dot(axis, d), 2) - 1);
    };
    CAPTURE(i, zh3.zonal);
    // The axis: where the first degree is greatest.
    CHECK(std::abs(zonal::reconstruct(zh3.linear, axis) - f[0] / std::sqrt(4 * pi) -
                   std::sqrt(3 / (4 * pi)) * std::sqrt(f[1] * f[1] + f[2] * f[2] + f[3] * f[3])) < 1e-13);
    CHECK(std::abs(zh3.zonal - probes::integral([&](const Vec3& d) { return zonal::reconstruct(f, d) * y2(d); })) <
          1e-12);
    const Vec3 n = random.direction();
    const auto radiance = [&](const Vec3& d) { return zonal::reconstruct(zh3, d); };
    CHECK(std::abs(radiance(n) - zonal::reconstruct(zh3.linear, n) - zh3.zonal * y2(n)) < 1e-13);
    CHECK(std::abs(radiance(n) - zonal::reconstruct(zonal::expand(zh3), n)) < 1e-13);
    CHECK(std::abs(zonal::irradiance_over_pi(zh3, n) - probes::irradiance_over_pi(radiance, n)) < 1e-12);
  }
}

TEST_CASE("probe: ZH3 hallucinated is the published fit") {
  probes::Random random(2);
  for (int i = 0; i < 20; ++i) {
    const auto f = zonal::with_bands<2>(random.function<3>(0.3 + 0.02 * i));
    const double r = std::sqrt(f[1] * f[1] + f[2] * f[2] + f[3] * f[3]) / f[0];
    CAPTURE(i, r);
    CHECK(std::abs(zonal::hallucinate_zh3(f).zonal - f[0] * r * (0.08 + 0.6 * r)) < 1e-14);
  }
  // Colours, on one axis: the share of each channel's degree 1 along it.
  const auto sh = colours(random, 0.4);
  const auto zh3 = zonal::hallucinate_zh3(zonal::with_bands<2>(sh));
  Sh<2, double> luminance{};
  for (int i = 0; i < 4; ++i) luminance[i] = 0.2126 * sh[i].r + 0.7152 * sh[i].g + 0.0722 * sh[i].b;
  const Vec3 axis = axis_of(luminance);
  for (int c = 0; c < 3; ++c) {
    const double ratio = std::abs(-sh[3][c] * axis[0] - sh[1][c] * axis[1] + sh[2][c] * axis[2]) / sh[0][c];
    CHECK(std::abs(zh3.zonal[c] - sh[0][c] * ratio * (0.08 + 0.6 * ratio)) < 1e-14);
  }
  const Sh<2, float> dark{};
  CHECK(std::abs(zonal::hallucinate_zh3(dark).zonal) <= 0);
}

TEST_CASE("probe: ZH3 solved errs least, and turns with the probe") {
  probes::Random random(3);
  double gained = 0;
  for (int i = 0; i < 20; ++i) {
    const auto sh = colours(random, i % 2 == 0 ? 0.2 : 0.6);
    for (const Zh3Axis kind : {Zh3Axis::luminance, Zh3Axis::channel}) {
      const auto projected = zonal::project_zh3(sh, kind), solved = zonal::solve_zh3(sh, kind);
      const double error = squared_error(sh, solved, kind), before = squared_error(sh, projected, kind);
      gained += before - error;
      CAPTURE(i, int(kind), error, before);
      CHECK(error <= before * (1 + 1e-12));
      for (int k = 0; k < 40; ++k) {  // none near is better
        Zh3<Rgb> other = solved;
        const double step = k % 2 == 0 ? 1e-2 : 1e-4;
        for (int c = 0; c < 3; ++c) {
          for (int j = 0; j < 4; ++j) other.linear[j][c] += step * random.normal();
          other.zonal[c] += step * random.normal();
        }
        CHECK(squared_error(sh, other, kind) >= error * (1 - 1e-9));
      }
      const auto turn = zonal::Rotation<3, double>::from_axis_angle(random.direction(), 1.0);
      CHECK(std::abs(squared_error(zonal::rotate(sh, turn), zonal::solve_zh3(zonal::rotate(sh, turn), kind), kind) -
                     error) < 1e-7 * before);
    }
  }
  CHECK(gained > 0.01);
  CHECK(squared_error(Sh<3, Rgb>{}, zonal::solve_zh3(Sh<3, Rgb>{}), Zh3Axis::luminance) <= 0);
}

TEST_CASE("probe: non-linear L1 is Geomerics' formula, keeps the mean, and is never negative") {
  probes::Random random(4);
  for (int i = 0; i <= 20; ++i) {
    const double share = i / 20.0;
    const Vec3 toward = random.direction();
    // Light from one direction, and the rest from all sides: its coefficients.
    Sh<2, double> sh = zonal::evaluate<2>(toward) * share;
    sh[0] = 1 / std::sqrt(4 * pi);
    const double r0 = 1 / (4 * pi), p = 1 + 2 * share, a = (1 - share) / (1 + share);
    const auto value = [&](const Vec3& d) { return zonal::nonlinear_irradiance_over_pi(sh, d); };
    const Vec3 n = random.direction(), away{-toward[0], -toward[1], -toward[2]};
    const double q = (1 + probes::dot(toward, n)) / 2;
    CAPTURE(i);
    CHECK(std::abs(value(n) - r0 * (a + (1 - a) * (p + 1) * std::pow(q, p))) < 1e-14);
    CHECK(std::abs(value(toward) - r0 * (a + (1 - a) * (p + 1))) < 1e-14);
    CHECK(std::abs(value(away) - r0 * a) < 1e-14);
    // q^p is no polynomial between whole p, and has its kink at q = 0: sums over the profile, of 4000 steps.
    double mean = 0, moment = 0;
    for (int k = 0; k < 4000; ++k) {
      const double c = (2 * k + 1.0) / 4000 - 1, s = std::sqrt((1 - c) * (1 + c));
      const Vec3 side = probes::direction(0, 1);
      Vec3 d{toward[1] * side[2] - toward[2] * side[1], toward[2] * side[0] - toward[0] * side[2],
             toward[0] * side[1] - toward[1] * side[0]};
      const double length = std::sqrt(probes::dot(d, d));
      for (std::size_t j = 0; j < 3; ++j) d[j] = s * d[j] / length + c * toward[j];
      mean += value(d) / 4000, moment += value(d) * c / 4000;
    }
    CHECK(std::abs(mean - r0) < 1e-7 * r0);
    // Linear, it is 2/3 r1; and what the header says of the model.
    const double right = 2.0 / 3 * share * r0;
    CHECK(std::abs(moment - right * 3 * (1 + 2 * share) / ((1 + share) * (3 + 2 * share))) < 1e-6 * r0);
    CHECK(moment <= 1.0295 * right + 1e-6 * r0);
    CHECK(moment >= 0.9 * right - 1e-6 * r0);
  }
  for (int i = 0; i < 2000; ++i) {
    const auto f = static_cast<Sh<2, float>>(zonal::with_bands<2>(random.function<3>(1)));  // also none that light has
    const Vec3 n = random.direction();
    CAPTURE(f[0], f[1], f[2], f[3]);
    CHECK(zonal::nonlinear_irradiance_over_pi(f, std::array<float, 3>{float(n[0]), float(n[1]), float(n[2])}) >= 0);
  }
  Sh<2, Rgb> even{};
  even[0] = {1, 2, 0};
  const Rgb colour = zonal::nonlinear_irradiance_over_pi(even, Vec3{0, 0, 1});
  CHECK(std::abs(colour.g - 2 / std::sqrt(4 * pi)) < 1e-15);
  CHECK(std::abs(colour.b) <= 0);
}
