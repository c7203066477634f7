#include <zonal/lobe/lambert.hpp>
#include <zonal/lobe/phong.hpp>
#include <zonal/lobe/spherical_gaussian.hpp>

#include <cmath>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../csv.hpp"

namespace {

constexpr int bands = 21;

template <class T>
zonal::Zh<bands, T> lobe(const std::string& name, const std::string& parameter) {
  if (name == "lambert") return zonal::project<bands, T>(zonal::LambertLobe{});
  const T value = static_cast<T>(std::stod(parameter));
  if (name == "phong") return zonal::project<bands>(zonal::PhongLobe<T>{value});
  return zonal::project<bands>(zonal::SphericalGaussian<T>{value});
}

template <class T>
void check_table() {
  for (const auto& row : read_csv_text("zonal_lobes.csv")) {
    const auto zh = lobe<T>(row[0], row[1]);
    double largest = 0;
    for (const T& z : zh) largest = std::max(largest, std::abs(static_cast<double>(z)));
    const int l = std::stoi(row[2]);
    const double bound = accuracy_bound(row[0] == "sg" ? "spherical_gaussian" : row[0], scalar_name<T>, bands);
    CAPTURE(row[0], row[1], l, scalar_name<T>);
    CHECK(std::abs(static_cast<double>(zh[l]) - std::strtod(row[3].c_str(), nullptr)) <= bound * largest);
  }
}

}  // namespace

TEST_CASE("lobes: Lambert, Phong and spherical Gaussian meet the reference table") {
  check_table<double>();
  check_table<float>();
}

namespace {

/// |T - long double with twice the bands|, against the largest coefficient.
template <class T>
double gaussian_error(T sharpness) {
  const auto zh = zonal::project<bands>(zonal::SphericalGaussian<T>{sharpness});
  const auto exact =
      zonal::project<2 * bands>(zonal::SphericalGaussian<long double>{static_cast<long double>(sharpness)});
  long double error = 0, largest = 0;
  for (int l = 0; l < bands; ++l) {
    error = std::max(error, std::abs(static_cast<long double>(zh[l]) - exact[l]));
    largest = std::max(largest, exact[l]);
  }
  return static_cast<double>(error / largest);
}

template <class T>
void check_gaussian_promise() {
  const double promise = accuracy_bound("spherical_gaussian", scalar_name<T>, bands);
  double worst = gaussian_error(T(0));
  for (double sharpness = 1e-6; sharpness <= 1e6; sharpness *= 1.01) {
    worst = std::max(worst, gaussian_error(static_cast<T>(sharpness)));
  }
  CAPTURE(scalar_name<T>, worst);
  CHECK(worst <= promise);
  CHECK(worst >= promise / 10);
}

}  // namespace

TEST_CASE("lobes: a spherical Gaussian of any sharpness, across its two regimes") {
  check_gaussian_promise<float>();
  check_gaussian_promise<double>();
}
