#include <zonal/gather/horizon.hpp>

#include <cmath>
#include <random>

#include "../catch.hpp"

namespace {

// The share of a cap above the horizon by definition: rings about the cap's axis, each cut by the horizon.
double share_by_quadrature(double half_angle, double cos_d) {
  const double pi = static_cast<double>(zonal::kPi), sin_d = std::sqrt(1 - cos_d * cos_d);
  constexpr int steps = 200000;
  const double low = std::cos(half_angle);
  double share = 0;
  for (int i = 0; i < steps; ++i) {
    const double u = low + (1 - low) * (i + 0.5) / steps, r = std::sqrt(1 - u * u);
    // normal . direction = cos_d u + sin_d r cos(phi) > 0
    const double bound = -cos_d * u / (sin_d * r);
    share += bound <= -1 ? 1 : bound >= 1 ? 0 : std::acos(bound) / pi;
  }
  return share / steps;
}

}  // namespace

TEST_CASE("horizon: the exact share is the share of the cap's solid angle") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const double a = trial < 100 ? uniform(random) * 1.5707 : std::pow(10.0, -6 * uniform(random));
    const double elevation = (2 * uniform(random) - 1) * a * 0.999;
    const double expected = share_by_quadrature(a, std::sin(elevation));
    CAPTURE(a, elevation);
    const auto cap = zonal::SphericalCap<double>::from_angle(a);
    CHECK(std::abs(zonal::horizon_exact(cap, std::sin(elevation)) - expected) < 1e-5);
    const zonal::SphericalCap<float> narrow{static_cast<float>(cap.cos_angle), static_cast<float>(cap.sin_angle)};
    CHECK(std::abs(static_cast<double>(zonal::horizon_exact(narrow, static_cast<float>(std::sin(elevation)))) -
                   expected) < 2e-3);
    CHECK(std::abs(zonal::horizon_smoothstep(cap, std::sin(elevation)) - expected) < 0.0963);  // of x and 3x^2 - 2x^3
  }
}

TEST_CASE("horizon: 1 above, 0 below, one half on the horizon, monotone between, for every size") {
  for (const float sine : {0.0F, 1e-12F, 1e-6F, 1e-3F, 0.1F, 0.9F, 1.0F}) {
    const auto cap = zonal::SphericalCap<float>::from_sphere(1.0F, sine);
    float last_smooth = 0, last_exact = 0;
    for (int i = -1000; i <= 1000; ++i) {
      const float cosine = static_cast<float>(i) / 1000.0F;
      const float smooth = zonal::horizon_smoothstep(cap, cosine), exact = zonal::horizon_exact(cap, cosine);
      CAPTURE(sine, cosine);
      CHECK(smooth >= last_smooth);
      CHECK(exact >= last_exact - 2e-6F);
      if (i == 0 && sine > 0) {
        CHECK(smooth == 0.5F);
        CHECK(std::abs(exact - 0.5F) <= 1e-6F);
      }
      if (std::abs(cosine) < sine) {
        const double x = 0.5 * (1 + std::asin(static_cast<double>(cosine)) / std::asin(static_cast<double>(sine)));
        CHECK(std::abs(static_cast<double>(smooth) - x * x * (3 - 2 * x)) <= 1e-6);
      }
      if (cosine > 0 && cosine >= sine) CHECK((smooth == 1 && exact == 1));
      if (cosine < 0 && -cosine >= sine) CHECK((smooth == 0 && exact == 0));
      last_smooth = smooth, last_exact = exact;
    }
  }
}
