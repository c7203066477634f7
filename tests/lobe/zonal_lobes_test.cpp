#include <zonal/lobe/lambert.hpp>
#include <zonal/lobe/phong.hpp>
#include <zonal/lobe/spherical_gaussian.hpp>

#include <cmath>

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
void check_table(double bound) {
  for (const auto& row : read_csv_text("zonal_lobes.csv")) {
    const auto zh = lobe<T>(row[0], row[1]);
    double largest = 0;
    for (const T& z : zh) largest = std::max(largest, std::abs(static_cast<double>(z)));
    const int l = std::stoi(row[2]);
    CAPTURE(row[0], row[1], l);
    CHECK(std::abs(static_cast<double>(zh[l]) - std::strtod(row[3].c_str(), nullptr)) <= bound * largest);
  }
}

}  // namespace

TEST_CASE("lobes: Lambert, Phong and spherical Gaussian meet the reference table") {
  check_table<double>(5e-16);
  check_table<float>(2.5e-7);
}

TEST_CASE("lobes: a spherical Gaussian of any sharpness is smooth across its two regimes") {
  for (double sharpness = 1e-6; sharpness < 1e6; sharpness *= 1.1) {
    const auto narrow = zonal::project<bands>(zonal::SphericalGaussian<float>{static_cast<float>(sharpness)});
    const auto wide = zonal::project<bands>(
        zonal::SphericalGaussian<long double>{static_cast<long double>(static_cast<float>(sharpness))});
    const auto exact = zonal::project<2 * bands>(
        zonal::SphericalGaussian<long double>{static_cast<long double>(static_cast<float>(sharpness))});
    double largest = 0;
    for (int l = 0; l < bands; ++l) largest = std::max(largest, static_cast<double>(exact[l]));
    for (int l = 0; l < bands; ++l) {
      CAPTURE(sharpness, l);
      CHECK(std::abs(static_cast<double>(wide[l] - exact[l])) <= 1e-15 * largest);
      CHECK(std::abs(static_cast<double>(static_cast<long double>(narrow[l]) - exact[l])) <=
            1e-6 * largest);
    }
  }
}
