// Coefficients that are colours, of whatever type: T(0) and T{} need not be black.
#include <zonal/zonal.hpp>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "../catch.hpp"

namespace {

// Whatever it is not given is not a number. It has no constructor from a number.
struct Colour {
  float r = std::numeric_limits<float>::quiet_NaN(), g = r;

  Colour() = default;
  Colour(float red, float green) : r(red), g(green) {}
  explicit Colour(int) {}

  float operator[](int i) const { return i == 0 ? r : g; }
  friend Colour operator+(const Colour& a, const Colour& b) { return {a.r + b.r, a.g + b.g}; }
  friend Colour operator*(const Colour& a, float s) { return {a.r * s, a.g * s}; }
  friend Colour operator*(float s, const Colour& a) { return a * s; }
};

// An expression that refers to its factors, as all of Eigen's, and a colour whose T(0) is a size.
using Eigen::Vector3f;

Colour make(const Colour*, float a, float b) { return {a, b}; }
Vector3f make(const Vector3f*, float a, float b) { return {a, b, a}; }

std::array<float, 3> random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

// Every function that takes colours, against itself with the numbers of each channel.
template <int N, class C>
void check_channels() {
  std::mt19937 random(31);
  std::uniform_real_distribution<float> uniform(0.5F, 1);
  zonal::Sh<N, C> sh;
  zonal::Zh<N, C> zh;
  zonal::EvenSh<N, C> even;
  zonal::Sh<N, float> channel_sh[2], weights;
  zonal::Zh<N, float> channel_zh[2], kernel = zonal::project<N>(zonal::PhongLobe<float>{4.0F});
  zonal::EvenSh<N, float> channel_even[2], even_weights;
  const auto fill = [&](auto& colours, auto& channels) {
    for (int i = 0; i < colours.size(); ++i) {
      channels[0][i] = uniform(random), channels[1][i] = uniform(random);
      colours[i] = make(static_cast<const C*>(nullptr), channels[0][i], channels[1][i]);
    }
  };
  fill(sh, channel_sh), fill(zh, channel_zh), fill(even, channel_even);
  for (float& w : weights) w = uniform(random);
  for (float& w : even_weights) w = uniform(random);

  const auto check = [](const C& colour, float first, float second) {
    CAPTURE(N);
    CHECK(std::abs(colour[0] - first) <= 2e-6F);
    CHECK(std::abs(colour[1] - second) <= 2e-6F);
  };
  const auto d = random_direction(random);
  const auto both = [&](auto f) { check(f(sh), f(channel_sh[0]), f(channel_sh[1])); };
  const auto hundredth = [](auto sum) {
    return decltype(sum)(sum * 0.01F);
  };  // no expression that outlives its factors
  both([&](const auto& s) { return zonal::reconstruct(s, d); });
  both([&](const auto& s) { return zonal::reconstruct_convolved(s, kernel, d); });
  both([&](const auto& s) { return zonal::reconstruct_convolved(s, zonal::LambertLobe{}, d); });
  both([&](const auto& s) { return zonal::reconstruct(zonal::convolve(s, kernel), d); });
  both([&](const auto& s) { return hundredth(zonal::dot(s, weights)); });
  both([&](const auto& s) { return hundredth(zonal::dot(weights, s)); });
  both([&](const auto& s) { return (zonal::apply_window(s, zonal::Window::sinc) * 2.0F)[N * N - 1]; });
  check(zonal::reconstruct_zonal(zh, 0.3F), zonal::reconstruct_zonal(channel_zh[0], 0.3F),
        zonal::reconstruct_zonal(channel_zh[1], 0.3F));
  check(zonal::dot(zh, kernel), zonal::dot(channel_zh[0], kernel), zonal::dot(channel_zh[1], kernel));
  check(zonal::dot(even, even_weights) * 0.01F, zonal::dot(channel_even[0], even_weights) * 0.01F,
        zonal::dot(channel_even[1], even_weights) * 0.01F);
}

}  // namespace

TEST_CASE("colours: whatever their T(0) and T{} are, each channel is as alone") {
  check_channels<1, Colour>();
  check_channels<3, Colour>();
  check_channels<1, Vector3f>();
  check_channels<2, Vector3f>();
  check_channels<4, Vector3f>();
}

TEST_CASE("colours: irradiance of a white sky in Eigen's colours") {
  zonal::Sh<3, Vector3f> sh;
  for (Vector3f& c : sh) c = Vector3f(1, 1, 1);
  const auto lambert = zonal::project<3, float>(zonal::LambertLobe{});
  const Vector3f white = zonal::reconstruct_convolved(sh, lambert, Vector3f(0, 0, 1));
  for (int c = 0; c < 3; ++c) CHECK(std::abs(white[c] - 0.765526F) <= 1e-6F);
}

TEST_CASE("dot: of more bands than a compiler nests a fold expression") {
  zonal::Sh<21, float> a;
  for (int i = 0; i < a.size(); ++i) a[i] = float(i % 5);
  CHECK(std::abs(zonal::dot(a, a) - 2640) <= 1e-3F);  // 441 = 88 times 0 1 4 9 16, and a 0
}
