// Dominant lights against what they were made of; six floats against Quake II RTX's own lines; storage against its
// bounds.
#include <zonal/environment/rgb.hpp>
#include <zonal/probe/dominant_light.hpp>
#include <zonal/probe/six_floats.hpp>
#include <zonal/probe/storage.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "../catch.hpp"
#include "probes.hpp"

namespace {

using probes::pi;
using probes::Vec3;
using zonal::LightFit;
using zonal::Sh;
using Rgb = zonal::Rgb<double>;

template <int N>
Sh<N, Rgb> light_and_ambient(const Vec3& direction, const Rgb& irradiance, const Rgb& ambient) {
  Sh<N, Rgb> sh = zonal::evaluate<N>(direction) * irradiance;
  sh[0] += ambient * std::sqrt(4 * pi);
  return sh;
}
double largest(const Rgb& c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

template <int N, LightFit fit>
void check_found(probes::Random& random) {
  const Vec3 d = random.direction();
  const Rgb irradiance{3, 2, 1}, ambient{0.1, 0.2, 0.4};
  const auto sh = light_and_ambient<N>(d, irradiance, ambient);
  const auto light = zonal::dominant_light<fit>(sh);
  CAPTURE(N, int(fit), d);
  CHECK(probes::dot(light.direction, d) > 1 - 1e-14);
  CHECK(largest(light.irradiance - irradiance) < 1e-13);
  CHECK(largest(light.ambient - ambient) < 1e-13);
  CHECK(largest((zonal::project<N>(light) - sh)[0]) < 1e-13);
  const auto alone = light_and_ambient<N>(d, irradiance, {0, 0, 0});
  CHECK(largest(zonal::dominant_light<fit>(alone, false).irradiance - irradiance) < 1e-13);
  CHECK(largest(zonal::dominant_light<fit>(alone, false).ambient) <= 0);
}

}  // namespace

TEST_CASE("probe: the dominant light is the one there is") {
  probes::Random random(1);
  check_found<2, LightFit::irradiance>(random);
  check_found<2, LightFit::radiance>(random);
  check_found<3, LightFit::irradiance>(random);
  check_found<3, LightFit::radiance>(random);
  check_found<5, LightFit::irradiance>(random);
}

TEST_CASE("probe: the dominant light errs least, and is Sloan's at three bands") {
  probes::Random random(2);
  for (int i = 0; i < 10; ++i) {
    const auto f = random.function<3>(0.4);
    const auto light = zonal::dominant_light(f);
    const Vec3 d{light.direction[0], light.direction[1], light.direction[2]};
    // Stupid SH tricks: both convolved, the light with 16 pi/17, E/pi of which is 1 at most; c = 867/(316 pi) sum L R.
    const auto of_light = zonal::irradiance_over_pi(zonal::evaluate<3>(d) * (16 * pi / 17));
    const auto of_probe = zonal::irradiance_over_pi(f);
    double sum = 0;
    for (int k = 1; k < 9; ++k) sum += of_light[k] * of_probe[k];
    CAPTURE(i);
    CHECK(std::abs(std::max(867 / (316 * pi) * sum, 0.0) * 16 * pi / 17 - light.irradiance) < 1e-12);
    const auto error = [&](double irradiance, double ambient) {
      return probes::integral([&](const Vec3& n) {
        const double difference =
            zonal::reconstruct(of_probe, n) - ambient -
            irradiance / pi * zonal::reconstruct(zonal::irradiance_over_pi(zonal::evaluate<3>(d) * pi), n);
        return difference * difference;
      });
    };
    const double least = error(light.irradiance, light.ambient);
    for (const double step : {-1e-3, 1e-3}) {
      if (light.irradiance + step > 0) CHECK(error(light.irradiance + step, light.ambient) > least);
      CHECK(error(light.irradiance, light.ambient + step) > least);
    }
  }
}

TEST_CASE("probe: a light is taken out, and nothing below zero is left") {
  probes::Random random(3);
  const std::vector<Vec3> directions = probes::spread(1000);
  for (int i = 0; i < 20; ++i) {
    const Vec3 sun = random.direction();
    Sh<3, Rgb> sh = light_and_ambient<3>(sun, Rgb{3, 2.5, 2} * random.uniform(0.1, 2), Rgb{0.2, 0.3, 0.4});
    const bool is_pure = i % 2 == 0;
    if (!is_pure) sh += zonal::evaluate<3>(random.direction()) * Rgb{0.3, 0.2, 0.1};
    const auto taken = zonal::extract_light(sh);
    CAPTURE(i, taken.share);
    const Sh<3, Rgb> back = taken.rest + zonal::project<3>(taken.light) - sh;
    for (const Rgb& c : back) CHECK(largest(c) < 1e-13);
    double least[3] = {1e9, 1e9, 1e9};
    for (const Vec3& d : directions) {
      const Rgb e = zonal::reconstruct(zonal::irradiance_over_pi(taken.rest), d);
      for (int c = 0; c < 3; ++c) least[c] = std::min(least[c], e[c]);
    }
    CHECK(std::min({least[0], least[1], least[2]}) >= 0);
    if (is_pure) CHECK(std::abs(taken.share - 1) <= 0);
    if (taken.share < 1) CHECK(std::min({least[0], least[1], least[2]}) < 5e-3);  // no more could be taken
    const auto all = zonal::extract_light(sh, false);
    CHECK(std::abs(all.share - 1) <= 0);
  }
  const Sh<3, double> ringing = zonal::evaluate<3>(Vec3{0, 0, 1}) + zonal::evaluate<3>(Vec3{1, 0, 0});
  CHECK(std::abs(zonal::extract_light(ringing, true, LightFit::radiance).share) <= 0);
}

TEST_CASE("probe: six floats as Quake II RTX encodes and resolves them") {
  probes::Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Vec3 d = random.direction(), n = random.direction();
    const Rgb colour{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
    // irradiance_to_SH of a sample, project_SH_irradiance at a normal; their order of degree 1 is x, y, z.
    const double co = colour.r - colour.b, t = colour.b + co * 0.5, cg = colour.g - t, y = t + cg * 0.5;
    const double w = 0.282095 * y, along = 0.488603 * y * probes::dot(d, n);
    const double resolved = std::max(2.0 * (1.023326 * along + 0.886226 * w), 0.0),
                 scale = resolved * 0.282095 / (w + 1e-6);
    const double t1 = resolved - scale * cg * 0.5, g = scale * cg + t1, b = t1 - scale * co * 0.5, r = b + scale * co;
    const auto six = zonal::to_six_floats(zonal::evaluate<2>(d) * colour);
    const Rgb own = zonal::irradiance_over_pi<Rgb>(six, n) * (2 * pi);  // theirs is twice E
    CAPTURE(i, own.r, own.g, own.b);
    CHECK(std::abs(own.r - std::max(r, 0.0)) < 2e-5);
    CHECK(std::abs(own.g - std::max(g, 0.0)) < 2e-5);
    CHECK(std::abs(own.b - std::max(b, 0.0)) < 2e-5);
    if (resolved > 0) {
      const Rgb expanded = zonal::reconstruct(zonal::irradiance_over_pi(zonal::expand<Rgb>(six)), n) * (2 * pi);
      CHECK(largest(expanded - own) < 1e-12);
    }
    const double luma = zonal::nonlinear_irradiance_over_pi(six.luminance, n);
    const Rgb smooth = zonal::irradiance_over_pi<Rgb, zonal::SixFloatsShape::nonlinear>(six, n);
    CHECK(std::abs(smooth.r / 4 + smooth.g / 2 + smooth.b / 4 - luma) < 1e-14);
  }
}

TEST_CASE("probe: what halves and bytes lose stays within their bounds") {
  probes::Random random(5);
  for (int i = 0; i < 300; ++i) {
    const float scale = static_cast<float>(std::pow(10.0, random.uniform(-3, 4)));
    const auto sh = static_cast<Sh<3, float>>(random.function<3>(i % 2 == 0 ? 0.3 : 2)) * scale;
    const auto halves = zonal::to_halves(sh);
    const auto bytes = zonal::to_bytes(sh);
    const auto by_band = zonal::to_bytes<zonal::ByteScale::band>(sh);
    CAPTURE(i, scale);
    for (int l = 0; l < 3; ++l) {
      float greatest = 0, in_degree = 0;
      for (const float x : sh) greatest = std::max(greatest, std::abs(x));
      for (int k = l * l; k < (l + 1) * (l + 1); ++k) in_degree = std::max(in_degree, std::abs(sh[k]));
      for (int k = l * l; k < (l + 1) * (l + 1); ++k) {
        const double x = double(sh[k]);
        CHECK(std::abs(double(zonal::to_floats(halves)[k]) - x) <= std::max(std::abs(x) * 0x1p-11, 0x1p-25));
        CHECK(std::abs(double(zonal::to_floats(bytes)[k]) - x) <= double(greatest) / 254 * (1 + 0x1p-10) * (1 + 1e-6));
        CHECK(std::abs(double(zonal::to_floats(by_band)[k]) - x) <=
              double(in_degree) / 254 * (1 + 0x1p-10) * (1 + 1e-6));
      }
    }
    const auto f = static_cast<Sh<3, double>>(sh);
    for (int k = 0; k < 20; ++k) {
      const Vec3 d = random.direction();
      const std::array<float, 3> direction{float(d[0]), float(d[1]), float(d[2])};
      const double exact = zonal::reconstruct(f, d), rounding = 1e-6 * double(scale) * 10;
      CHECK(std::abs(double(zonal::reconstruct(halves, direction)) - exact) <= zonal::value_error(halves) + rounding);
      CHECK(std::abs(double(zonal::reconstruct(bytes, direction)) - exact) <= zonal::value_error(bytes) + rounding);
      CHECK(std::abs(double(zonal::reconstruct(by_band, direction)) - exact) <= zonal::value_error(by_band) + rounding);
      const auto agrees = [&](const auto& stored) {
        const double own = double(zonal::irradiance_over_pi(stored, direction));
        const auto plain = static_cast<Sh<3, double>>(zonal::to_floats(stored));
        return std::abs(own - zonal::reconstruct_convolved(plain, zonal::LambertLobe{}, d)) <= rounding;
      };
      CHECK((agrees(halves) && agrees(bytes) && agrees(by_band)));
    }
  }
  CHECK(sizeof(zonal::HalfSh<3>) == 18);
  CHECK(sizeof(zonal::ByteSh<3>) == 12);  // 11, and one for the scale's alignment
  CHECK(std::abs(zonal::to_floats(zonal::to_halves(Sh<1, float>{{1e6F}}))[0] - 65504.0F) <= 0);
  CHECK(std::abs(zonal::to_floats(zonal::to_bytes(Sh<2, float>{{0, 0, 0, 0}}))[3]) <= 0);
  CHECK(std::abs(zonal::to_floats(zonal::to_bytes(Sh<1, float>{{8e6F}}))[0] / 8e6F - 1) <= 1e-3F);
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const auto odd = zonal::to_floats(zonal::to_bytes(Sh<2, float>{{1, nan, infinity, -infinity}}));
  CHECK(std::abs(odd[1]) <= 0);
  CHECK(std::abs(odd[2] + odd[3]) <= 0);
  CHECK(odd[2] > 8e6F);
}
