// Spherical Gaussians above a horizon, against quadrature.
#include <zonal/lobe/gaussian_horizon.hpp>
#include <zonal/lobe/gaussian_product.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/scalar/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../catch.hpp"

namespace {

const double pi = static_cast<double>(zonal::kPi);

struct Above {
  double share, cosine;
};

/// By rings about the SG's axis: of a ring the part above the horizon and the mean height there are known, with kinks
/// where it comes to meet the horizon.
Above by_quadrature(double cosine, double sharpness) {
  static const zonal::QuadratureRule rule = zonal::gauss_legendre(200);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine)), range = std::min(2.0, 60 / sharpness);
  Above sum{0, 0};
  double whole = 0, low = 0;
  for (const double kink : {1 - sine, 1 + sine, 2.0}) {
    const double high = std::min(kink, range);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double x = 0.5 * (1 + rule.nodes[i]), fall = low + (high - low) * x * x * (3 - 2 * x);
      const double weight = std::exp(-sharpness * fall) * rule.weights[i] * (high - low) * x * (1 - x);
      const double along = cosine * (1 - fall), across = sine * std::sqrt(fall * (2 - fall));
      const double angle = std::acos(std::clamp(-along / std::max(across, 1e-300), -1.0, 1.0));
      whole += weight;
      sum.share += weight * angle / pi;
      sum.cosine += weight * (along * angle + across * std::sin(angle)) / pi;
    }
    low = high;
  }
  return {sum.share / whole, sum.cosine / whole};
}

struct Worst {
  double share = 0, cosine = 0;
};

/// Over all angles and sharpnesses.
template <class T>
Worst greatest_errors() {
  Worst worst;
  for (int i = -16; i <= 48; ++i) {
    const double sharpness = std::pow(10.0, i / 8.0);
    for (int j = -40; j <= 40; ++j) {
      const double cosine = j / 40.0;
      const Above exact = by_quadrature(cosine, sharpness);
      const auto got = zonal::detail::gaussian_above_horizon(T(cosine), T(sharpness));
      worst.share = std::max(worst.share, std::abs(static_cast<double>(got.share) - exact.share));
      worst.cosine = std::max(worst.cosine, std::abs(static_cast<double>(got.cosine) - exact.cosine));
      CAPTURE(sharpness, cosine, got.share, got.cosine, exact.share, exact.cosine);
      CHECK((got.share >= 0 && got.share <= 1 && got.cosine >= 0 && got.cosine <= 1 && got.mean_cosine() >= 0));
      if (std::abs(j) == 40) {
        CHECK(std::abs(static_cast<double>(got.share) - exact.share) < 2e-6);
        CHECK(std::abs(static_cast<double>(got.cosine) - exact.cosine) < 2e-6);
      }
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("spherical Gaussian: what is above a horizon is as exact as is said") {
  const auto in_double = greatest_errors<double>();
  const auto in_float = greatest_errors<float>();
  CAPTURE(in_double.share, in_double.cosine, in_float.share, in_float.cosine);
  CHECK((in_double.share <= 0.009 && in_double.share > 0.007));
  CHECK((in_double.cosine <= 0.0023 && in_double.cosine > 0.0018));
  CHECK((in_float.share <= 0.009 && in_float.cosine <= 0.0023));
}

TEST_CASE("spherical Gaussian: above a horizon, packets give what floats give, and extremes are finite") {
  using Lanes = zonal::Packet<float, 8>;
  for (const float sharpness : {0.0F, 1e-6F, 1e-3F, 0.7F, 5.0F, 300.0F, 1e6F, 1e12F}) {
    for (const float cosine : {-1.0F, -0.4F, -1e-8F, 0.0F, 0.3F, 1.0F}) {
      const auto one = zonal::detail::gaussian_above_horizon(cosine, sharpness);
      const auto lanes = zonal::detail::gaussian_above_horizon(Lanes(cosine), Lanes(sharpness));
      CAPTURE(sharpness, cosine, one.share, one.cosine, lanes.share[3], lanes.cosine[3]);
      CHECK((std::isfinite(one.share) && std::isfinite(one.cosine) && std::isfinite(one.mean_cosine())));
      CHECK(std::abs(lanes.share[3] - one.share) < 2e-6F);
      CHECK(std::abs(lanes.cosine[3] - one.cosine) < 2e-6F);
    }
  }
}

TEST_CASE(
    "spherical Gaussian: the mean direction's length is that of the definition, and turns back to the sharpness") {
  for (int i = -32; i <= 48; ++i) {
    const double sharpness = std::pow(10.0, i / 8.0), length = zonal::detail::gaussian_mean_length(sharpness);
    const long double wide = static_cast<long double>(sharpness);
    const long double exact = wide < 0.1L ? wide / 3 - wide * wide * wide / 45 + 2 * std::pow(wide, 5.0L) / 945
                                          : 1 / std::tanh(wide) - 1 / wide;
    CAPTURE(sharpness, length);
    CHECK(std::abs(length - static_cast<double>(exact)) <= 1e-9 * length);
    const auto in_float = static_cast<double>(zonal::detail::gaussian_mean_length(static_cast<float>(sharpness)));
    CHECK(std::abs(in_float - length) <= 1e-6 * length);
    CHECK(std::abs(zonal::detail::gaussian_sharpness(length) - sharpness) <= 1e-5 * sharpness);
  }
  CHECK(zonal::detail::gaussian_sharpness(0) == 0);
}

TEST_CASE("spherical Gaussian: the complementary error function is the standard library's") {
  for (int i = -1000; i <= 1000; ++i) {
    const double x = i / 100.0;
    const auto got = zonal::detail::gaussian_tail(x);
    CAPTURE(x);
    CHECK(std::abs(got.integral - std::erfc(x)) <= 2e-7);
    CHECK(std::abs(got.density - std::exp(-x * x)) <= 1e-15);
    CHECK(std::abs(static_cast<double>(zonal::detail::gaussian_tail(static_cast<float>(x)).integral) - std::erfc(x)) <=
          5e-7);
  }
}
