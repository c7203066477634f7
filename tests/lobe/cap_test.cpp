#include <zonal/kernels/lobe_kernels.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/lobe/cap.hpp>

#include <cmath>
#include <random>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../csv.hpp"

namespace {

template <int N, class T>
double largest(const zonal::Zh<N, T>& zh) {
  double result = 0;
  for (const T& z : zh) result = std::max(result, std::abs(static_cast<double>(z)));
  return result;
}

using Value = zonal::kernels::Cap;
using UpToHemisphere = zonal::kernels::HemisphereCap;
using Derivative = zonal::kernels::CapDerivative;

template <class Kind, int N, class T>
zonal::Zh<N, T> of(const zonal::SphericalCap<T>& cap) {
  const T inputs[] = {cap.cos_angle, cap.sin_angle};
  zonal::Zh<N, T> zh{};
  zonal::kernels::run_plainly<Kind, N>(inputs, zh.values);
  return zh;
}

// |T - long double| against the largest coefficient, for the same sine and either side of the hemisphere.
template <class Kind, int N, class T>
double cap_error(T sin_angle, bool beyond) {
  auto cap = zonal::SphericalCap<T>::from_sphere(T(1), sin_angle);
  auto exact = zonal::SphericalCap<long double>::from_sphere(1, static_cast<long double>(sin_angle));
  if (beyond) cap.cos_angle = -cap.cos_angle, exact.cos_angle = -exact.cos_angle;
  const auto zh = of<Kind, N>(cap);
  const auto reference = of<Kind, N>(exact);
  double error = 0;
  for (int l = 0; l < N; ++l) {
    error = std::max(error, static_cast<double>(std::abs(static_cast<long double>(zh[l]) - reference[l])));
  }
  return error / largest(reference);
}

template <class Kind, int N, class T>
void check_promise() {
  double worst = 0;
  for (int i = 0; i <= 24000; ++i) {
    const T sine = static_cast<T>(std::pow(10.0, -12.0 * i / 24000));
    const T near_one = T(1) - static_cast<T>(std::pow(10.0, -7.0 * i / 24000));
    for (const T s : {sine, near_one}) {
      worst = std::max(worst, cap_error<Kind, N>(s, false));
      if constexpr (!std::is_same_v<Kind, UpToHemisphere>) worst = std::max(worst, cap_error<Kind, N>(s, true));
    }
  }
  CAPTURE(Kind::name, N, scalar_name<T>, worst);
  const Accuracy promise = accuracy_of(Kind::name, scalar_name<T>, N);
  CHECK(worst <= promise.bound);
  CHECK(worst <= 1.25 * promise.worst);  // here the cap's cosine is rounded as well
  CHECK(worst >= promise.worst / 10);
}

}  // namespace

TEST_CASE("cap: meets the reference table in double to 51 bands") {
  for (const auto& row : read_csv("cap.csv")) {
    const double sine = row[0], side = row[1], expected = row[3];
    const int l = static_cast<int>(row[2]);
    const zonal::SphericalCap<double> cap{side * std::sqrt((1 - sine) * (1 + sine)), sine};
    const auto zh = zonal::project<51>(cap);
    CAPTURE(sine, side, l);
    CHECK(std::abs(zh[l] - expected) <= 2e-15 * largest(zh));
  }
}

TEST_CASE("cap: the long double kernel, the reference of the next test, meets the table too") {
  for (const auto& row : read_csv("cap.csv")) {
    const long double sine = static_cast<long double>(row[0]);
    const zonal::SphericalCap<long double> cap{static_cast<long double>(row[1]) * std::sqrt((1 - sine) * (1 + sine)),
                                               sine};
    const int l = static_cast<int>(row[2]);
    const auto zh = zonal::project<51>(cap);
    CAPTURE(row[0], row[1], l);
    CHECK(std::abs(static_cast<double>(zh[l]) - row[3]) <= 3e-16 * largest(zh));
  }
}

TEST_CASE("cap: rounding error at every angle from sin a = 1e-12 to beyond the hemisphere") {
  check_promise<Value, 10, float>();
  check_promise<Derivative, 10, float>();
  check_promise<Value, 21, float>();
  check_promise<Derivative, 21, float>();
  check_promise<Value, 51, float>();
  check_promise<Derivative, 51, float>();
  check_promise<Value, 51, double>();
  check_promise<Derivative, 51, double>();
}

TEST_CASE("cap: its derivative meets the reference table") {
  for (const auto& row : read_csv("cap.csv")) {
    const double sine = row[0], side = row[1], expected = row[4];
    const auto zh =
        zonal::project_derivative<51>(zonal::SphericalCap<double>{side * std::sqrt((1 - sine) * (1 + sine)), sine});
    const int l = static_cast<int>(row[2]);
    CAPTURE(sine, side, l);
    CHECK(std::abs(zh[l] - expected) <= 5e-15 * largest(zh));
  }
}

TEST_CASE("cap: by definition, quadrature of the basis over the cap") {
  for (const double angle : {0.01, 0.4, 1.2, 1.5707, 2.5, 3.1}) {
    const auto zh = zonal::project<12>(zonal::SphericalCap<double>::from_angle(angle));
    constexpr int steps = 60000;  // midpoint rule in cos theta
    zonal::Zh<12, double> sum{};
    const double low = std::cos(angle);
    for (int i = 0; i < steps; ++i) {
      const double u = low + (1 - low) * (i + 0.5) / steps;
      const double weight = 2 * static_cast<double>(zonal::kPi) * (1 - low) / steps;
      double before = 1, last = u;  // P_0, P_1
      for (int l = 0; l < 12; ++l) {
        const double p = l == 0 ? 1 : last;
        sum[l] += weight * p * std::sqrt((2 * l + 1) / (4 * static_cast<double>(zonal::kPi)));
        if (l >= 1) {
          const double next = ((2 * l + 1) * u * last - l * before) / (l + 1);
          before = last;
          last = next;
        }
      }
    }
    for (int l = 0; l < 12; ++l) {
      CAPTURE(angle, l);
      CHECK(std::abs(zh[l] - sum[l]) <= 1e-7 * largest(zh));
    }
  }
}

TEST_CASE("cap: a receiver inside the sphere sees a hemisphere, and the step at the surface is none") {
  const auto inside = zonal::project<6>(zonal::SphericalCap<double>::from_sphere(0.5, 1.0));
  const auto hemisphere = zonal::project<6>(zonal::SphericalCap<double>{0.0, 1.0});
  const auto outside = zonal::project<6>(zonal::SphericalCap<double>::from_sphere(1.0 + 1e-14, 1.0));
  for (int l = 0; l < 6; ++l) {
    CHECK(inside[l] == hemisphere[l]);
    CHECK(std::abs(outside[l] - hemisphere[l]) < 1e-6);
  }
}

TEST_CASE("cap up to the hemisphere: as accurate as promised, and equal to the other") {
  check_promise<UpToHemisphere, 10, float>();
  check_promise<UpToHemisphere, 21, float>();
  check_promise<UpToHemisphere, 21, double>();
  for (int i = 0; i <= 100; ++i) {
    const auto cap = zonal::SphericalCap<double>::from_sphere(1, i / 100.0);
    const auto fewer = of<UpToHemisphere, 10>(cap), all = zonal::project<10>(cap);
    for (int l = 0; l < 10; ++l) CHECK(std::abs(fewer[l] - all[l]) < 1e-14);
  }
}

TEST_CASE("cap: from_sphere keeps the height above the surface") {
  // At distance 1 + h the cosine is sqrt(h (2 + h)) / (1 + h): at h of one ulp as exact as anywhere.
  for (int power = -23; power <= 3; ++power) {
    const float distance = 1 + std::ldexp(1.0F, power);
    const double d = static_cast<double>(distance), exact = std::sqrt((d - 1) * (d + 1)) / d;
    for (const float scale : {1.0F, 0x1p-90F, 0x1p90F}) {
      const auto cap = zonal::SphericalCap<float>::from_sphere(distance * scale, scale);
      CAPTURE(power, scale);
      CHECK(std::abs(static_cast<double>(cap.cos_angle) - exact) <= 3e-7 * exact);
      CHECK(std::abs(static_cast<double>(cap.sin_angle) - 1 / d) <= 2e-7 / d);
    }
  }
  const auto inside = zonal::SphericalCap<float>::from_sphere(0.5F, 1.0F);
  CHECK(inside.cos_angle == 0);
  CHECK(inside.sin_angle == 1);
}
