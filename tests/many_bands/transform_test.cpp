// What is done to functions of many bands, by what it does to their values.
#include <zonal/many_bands/lobes.hpp>
#include <zonal/many_bands/rotate.hpp>
#include <zonal/many_bands/transform.hpp>
#include <zonal/zonal.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "directions.hpp"
#include "multiprecision.hpp"

namespace {

template <class T>
zonal::ManySh<T> random_function(int bands, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<T> normal;
  zonal::ManySh<T> f(bands);
  for (T& value : f) value = normal(random);
  return f;
}

template <class T>
T greatest_difference(const T* a, const T* b, int size) {
  T worst = 0;
  for (int i = 0; i < size; ++i) {
    const T difference = std::abs(a[i] - b[i]);
    if (!(difference <= worst)) worst = difference;
  }
  return worst;
}

// The basis at a direction, rotated, is the basis at the direction's rotation, which 34 digits know.
template <class T>
double rotation_error(int bands, const zonal::Rotation<2, T>& rotation, const Vector3<T>& v) {
  const zonal::ManyBands<T> constants(bands);
  const zonal::ManySh<T> turned = zonal::rotate(zonal::evaluate(constants, v), zonal::ManyRotation<T>(bands, rotation));
  const auto& first = rotation.turn(0);
  const auto& second = rotation.turn(1);
  const auto& third = rotation.turn(2);
  const auto turn = [](const zonal::TurnAboutZ<2, T>& by, WideVector d) {
    const Wide c = by.cosine[1], s = by.sine[1], length = sqrt(c * c + s * s);
    return WideVector{Wide((c * d[0] - s * d[1]) / length), Wide((s * d[0] + c * d[1]) / length), d[2]};
  };
  const auto swap = [](const WideVector& d) { return WideVector{d[0], d[2], d[1]}; };
  WideVector exact = turn(third, swap(turn(second, swap(turn(first, wide_direction(v))))));
  if (rotation.parity() < 0) exact = {-exact[0], -exact[1], -exact[2]};
  double worst = 0;
  WidePower power;
  for (int m = 0; m < bands; m += m < 3 ? 1 : 1 + m / 3) {
    WideColumn(bands, m).visit(exact, power, [&](int l, const Wide& even, const Wide& odd) {
      const auto meet = [&](int order, const Wide& value) {
        const double e = std::abs(static_cast<double>(Wide(turned(l, order)) - value)) / largest_of_degree(l);
        if (!(e <= worst)) worst = e;
      };
      meet(m, even);
      if (m > 0) meet(-m, odd);
    });
  }
  return worst;
}

template <class T>
void check_rotations(int bands) {
  CAPTURE(scalar_name<T>, bands);
  double worst = 0;
  const auto directions = directions_to_poles<T>(2, 3);
  const auto meet = [&](const zonal::Rotation<2, T>& rotation, const Vector3<T>& v) {
    const double e = rotation_error(bands, rotation, v);
    if (!(e <= worst)) worst = e;
  };
  meet(zonal::Rotation<2, T>::from_zyz(T(0.3), T(1.1), T(-2)), directions[0]);
  if (bands < 500) {
    meet(zonal::Rotation<2, T>::from_zyz(T(2.7), T(1e-3), T(0.4)), directions[1]);
    meet(zonal::Rotation<2, T>::from_axes(Vector3<T>{0, 1, 0}, Vector3<T>{1, 0, 0}, Vector3<T>{0, 0, 1}),
         directions[0]);
  }
  const double bound = many_bands_bound("rotate", scalar_name<T>, bands);
  INFO("worst " << worst);
  CHECK(worst <= bound);
  CHECK(worst >= bound / 20);
}

}  // namespace

TEST_CASE("many bands: the basis, rotated, is the basis at the rotated direction") {
  check_rotations<float>(190);
  check_rotations<double>(190);
  check_rotations<double>(1000);
}

TEST_CASE("many bands: what loops compute of few bands is what the unrolled kernels do") {
  constexpr int N = 9;
  const zonal::ManyBands<double> bands(N);
  const auto rotation = zonal::Rotation<N, double>::from_axis_angle(normalized(1.0, 2.0, 3.0), 0.7);
  const auto sharp = zonal::SphericalGaussian<double>{12.5};
  for (const auto& v : directions_to_poles<double>(20, 5)) {
    const auto f = random_function<double>(N, 8);
    zonal::Sh<N, double> few;
    std::copy(f.begin(), f.end(), few.begin());
    const auto zh = zonal::project<N>(sharp);
    CAPTURE(v[0], v[1], v[2]);
    CHECK(greatest_difference(zonal::orient(zh, v).values, zonal::orient(bands, zonal::ManyZh<double>(zh), v).data(),
                              N * N) <= 1e-14);
    CHECK(std::abs(zonal::reconstruct(few, v) - zonal::reconstruct(bands, f, v)) <= 1e-13);
    CHECK(greatest_difference(zonal::convolve(few, zh).values,
                              zonal::convolve(bands, f, zonal::project(bands, sharp)).data(), N * N) <= 1e-14);
    CHECK(greatest_difference(zonal::rotate(few, rotation).values,
                              zonal::rotate(f, zonal::ManyRotation<double>(N, rotation)).data(), N * N) <= 1e-13);
    CHECK(greatest_difference(zonal::rotate_about_z(few, 0.6, 0.8).values,
                              zonal::rotate(f, zonal::ManyTurn<double>(N, 0.6, 0.8)).data(), N * N) <= 1e-14);
    CHECK(std::abs(zonal::dot(few, few) - zonal::dot(f, f)) <= 1e-12);
  }
}

TEST_CASE("many bands: samples sum up to the function that they are taken of") {
  constexpr int N = 24;
  const zonal::ManyBands<double> bands(N);
  const auto f = random_function<double>(N, 2);
  zonal::BasisSpace<double> space(N);
  zonal::ManySh<double> sum(N);
  // A rule that is exact for products of two functions: Gauss's in z, even steps in azimuth.
  const zonal::HalfGaussRule<N> rule;
  for (int i = 0; i < N; ++i) {
    const int half = i < N / 2 ? i : N - 1 - i;
    const double z = static_cast<double>(rule.nodes[half]) * (i < N / 2 ? 1 : -1), sine = std::sqrt(1 - z * z);
    for (int j = 0; j < 2 * N; ++j) {
      const double phi = 3.14159265358979323846 * j / N;
      const Vector3<double> v{sine * std::cos(phi), sine * std::sin(phi), z};
      const double solid_angle = static_cast<double>(rule.weights[half]) * 3.14159265358979323846 / N;
      zonal::add_sample(bands, v, solid_angle * zonal::reconstruct(bands, f.data(), v, space), space, sum.data());
    }
  }
  CHECK(greatest_difference(sum.data(), f.data(), N * N) <= 1e-12);
}

TEST_CASE("many bands: several functions of colours are rotated as each of their numbers is") {
  constexpr int N = 30;
  using Colour = Eigen::Vector3d;
  const zonal::ManyRotation<double> rotation(N, zonal::Rotation<2, double>::from_zyz(0.4, 2.0, 0.1));
  std::vector<Colour> colours(2 * N * N), turned(2 * N * N), row(2 * N - 1);
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = Colour::Random();
  zonal::SwapOfDegree<double> swap(N);
  zonal::rotate(colours.data(), 2, rotation, swap, row.data(), turned.data());
  for (int function = 0; function < 2; ++function) {
    for (int channel = 0; channel < 3; ++channel) {
      zonal::ManySh<double> f(N);
      const auto at = [&](int i) { return static_cast<std::size_t>(function * N * N + i); };
      for (int i = 0; i < N * N; ++i) f[i] = colours[at(i)][channel];
      const auto expected = zonal::rotate(f, rotation);
      double worst = 0;
      for (int i = 0; i < N * N; ++i) worst = (std::max)(worst, std::abs(expected[i] - turned[at(i)][channel]));
      CHECK(worst <= 1e-13);
    }
  }
}

TEST_CASE("many bands: functions of fewer bands than a kernel has are refused") {
  const zonal::ManyBands<double> bands(5);
  const Vector3<double> v{0, 0.6, 0.8};
  CHECK_THROWS_WITH(zonal::reconstruct(bands, zonal::ManySh<double>(4), v),
                    "reconstruct: a function of 4 bands, where 5 are needed");
  CHECK_THROWS_AS(zonal::orient(bands, zonal::ManyZh<double>(4), v), std::invalid_argument);
  CHECK_THROWS_AS(zonal::convolve(bands, zonal::ManySh<double>(5), zonal::ManyZh<double>(4)), std::invalid_argument);
  CHECK_THROWS_AS(zonal::rotate(zonal::ManySh<double>(5), zonal::ManyTurn<double>(4, 1, 0)), std::invalid_argument);
}

TEST_CASE("many bands: rotations of more bands than the exchange of y and z has numbers for are refused") {
  CHECK_THROWS_WITH(zonal::SwapOfDegree<double>(1021), "SwapOfDegree: 1021 bands; from 1 to 1020 are possible");
  const auto half_turn = zonal::Rotation<2, double>::from_zyz(0, 1, 0);
  CHECK_THROWS_AS(zonal::ManyRotation<double>(1021, half_turn), std::invalid_argument);
  CHECK_THROWS_AS(zonal::rotate(zonal::ManySh<double>(9), zonal::ManyRotation<double>(8, half_turn)),
                  std::invalid_argument);
}
