// Zonal lobes of many bands, against 100 digits.
#include <zonal/many_bands/lobes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "multiprecision.hpp"

namespace {

const Widest pi = boost::math::constants::pi<Widest>();
Widest normalisation(int l) { return sqrt(Widest(2 * l + 1) / (4 * pi)); }

/// The greatest error of zonal coefficients by the largest of them, over all calls.
struct WorstOfLargest {
  double error = 0, parameter = 0;
  int degree = 0;

  template <class T>
  void meet(const zonal::ManyZh<T>& found, const std::vector<Widest>& exact, const std::vector<int>& degrees,
            double at) {
    Widest largest = 0;
    for (const Widest& z : exact) largest = (std::max)(largest, Widest(abs(z)));
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      const double e = static_cast<double>(Widest(abs(Widest(found[degrees[i]]) - exact[i]) / largest));
      if (e > error || std::isnan(e)) error = e, parameter = at, degree = degrees[i];
    }
  }
};

template <class T>
void check(const WorstOfLargest& worst, std::string_view kernel, int bands) {
  INFO("worst " << worst.error);
  CAPTURE(kernel, scalar_name<T>, bands, worst.parameter, worst.degree);
  const double bound = many_bands_bound(kernel, scalar_name<T>, bands);
  CHECK(worst.error <= bound);
  CHECK(worst.error >= bound / 20);
}

std::vector<int> all_degrees(int bands) {
  std::vector<int> degrees;
  for (int l = 0; l < bands; ++l) degrees.push_back(l);
  return degrees;
}
/// Some, each further from the one before.
std::vector<int> some_degrees(int bands) {
  std::vector<int> degrees;
  for (int l = 0; l < bands; l += 1 + l / 3) degrees.push_back(l);
  if (degrees.back() < bands - 1) degrees.push_back(bands - 1);
  return degrees;
}

template <class T>
void check_caps(int bands) {
  const zonal::ManyBands<T> constants(bands);
  const std::vector<int> degrees = all_degrees(bands);
  WorstOfLargest cap_error, slope_error, basis_error;
  for (const double sine : {1e-12, 1e-6, 1e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.03, 0.1, 0.3, 0.6, 0.9, 1.0}) {
    for (const double sign : {1.0, -1.0}) {
      const T s = static_cast<T>(sine);
      const Widest cosine = static_cast<int>(sign) * sqrt(1 - Widest(s) * s);
      const zonal::SphericalCap<T> cap{static_cast<T>(cosine), s};
      const std::vector<Widest> p = widest_legendre(bands + 1, cosine);
      std::vector<Widest> z{sqrt(pi) * (1 - cosine)}, slope;
      for (int l = 0; l < bands; ++l) {
        const auto i = static_cast<std::size_t>(l);
        if (l > 0) z.push_back(2 * pi * normalisation(l) / (2 * l + 1) * (p[i - 1] - p[i + 1]));
        slope.push_back(2 * pi * normalisation(l) * s * p[i]);
      }
      cap_error.meet(zonal::project(constants, cap), z, degrees, sign * sine);
      slope_error.meet(zonal::project_derivative(constants, cap), slope, degrees, sign * sine);

      const std::vector<Widest> of_cosine = widest_legendre(bands, cap.cos_angle);
      std::vector<Widest> values;
      for (int l = 0; l < bands; ++l) values.push_back(normalisation(l) * of_cosine[static_cast<std::size_t>(l)]);
      basis_error.meet(zonal::evaluate_zonal(constants, cap.cos_angle), values, degrees, sign * sine);
    }
  }
  check<T>(cap_error, "cap", bands);
  check<T>(slope_error, "cap_derivative", bands);
  check<T>(basis_error, "evaluate_zonal", bands);
}

template <class T>
void check_lobes(int bands) {
  const zonal::ManyBands<T> constants(bands);
  const std::vector<int> degrees = some_degrees(bands);
  // Cosine powers: 2 pi K_l (n+1)/(2 pi) times the integral of u^n P_l(u) from 0 to 1, which is
  // n (n-2) ... (n-l+2) / ((n+1) (n+3) ... (n+l+1)), l even, or (n-1) (n-3) ... (n-l+2) / ((n+2) (n+4) ... (n+l+1)), l
  // odd.
  const auto power_integral = [](int l, const Widest& n) {
    Widest integral = 1 / (n + 1 + l % 2);
    for (int i = 2 + l % 2; i <= l; i += 2) integral *= (n - i + 2) / (n + i + 1);
    return integral;
  };
  WorstOfLargest lambert, phong, gaussian;
  std::vector<Widest> exact;
  for (const int l : degrees) exact.push_back(2 * normalisation(l) * power_integral(l, 1));
  lambert.meet(zonal::project(constants, zonal::LambertLobe{}), exact, degrees, 0);
  for (const double exponent : {0.0, 0.5, 1.0, 7.0, 20.3, 100.0, 999.5, 1e4, 1e6}) {
    const T n = static_cast<T>(exponent);
    exact.clear();
    for (const int l : degrees) exact.push_back((Widest(n) + 1) * normalisation(l) * power_integral(l, n));
    phong.meet(zonal::project(constants, zonal::PhongLobe<T>{n}), exact, degrees, exponent);
  }
  for (const double sharpness : {1e-3, 0.9, 1.1, 30.0, 300.0, 1.5e3, 1.7e4, 1.9e4, 4.9e5, 5.1e5, 2e6, 1e8}) {
    const T lambda = static_cast<T>(sharpness);
    if (sharpness >= 2000 && sharpness < 0.2 * bands * bands) continue;  // where the sum of 100 digits does not reach
    exact.clear();
    for (const int l : degrees) exact.push_back(4 * pi * normalisation(l) * scaled_bessel(l, lambda));
    gaussian.meet(zonal::project(constants, zonal::SphericalGaussian<T>{lambda}), exact, degrees, sharpness);
  }
  check<T>(lambert, "lambert", bands);
  check<T>(phong, "phong", bands);
  check<T>(gaussian, "spherical_gaussian", bands);
}

}  // namespace

TEST_CASE("many bands: caps, their derivatives and zonal harmonics against 100 digits") {
  check_caps<float>(190);
  check_caps<double>(190);
  check_caps<double>(1000);
}

TEST_CASE("many bands: lobes against 100 digits") {
  check_lobes<float>(190);
  check_lobes<double>(190);
  check_lobes<double>(1000);
}
