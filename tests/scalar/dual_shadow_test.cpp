// Dual against central differences, Shadow against a known cancellation, and the basis in both.
#include <zonal/basis/evaluate.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/math.hpp>
#include <zonal/scalar/shadow.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

using Dual2 = zonal::Dual<double, 2>;

/// Both partial derivatives of f(a, b), and its value, at points of a fixed seed.
template <class F>
void check_derivatives(const char* what, F f) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  for (int i = 0; i < 100; ++i) {
    const double a = (i % 2 ? 1 : -1) * uniform(random), b = uniform(random), h = 1e-6;
    if (std::abs(std::abs(a) - 0.5) < 0.01 || std::abs(a - b) < 0.01) continue;  // near a branch of asin, min, max
    CAPTURE(what, a, b);
    const Dual2 result = f(Dual2::variable(a, 0), Dual2::variable(b, 1));
    REQUIRE(result.value == Catch::Approx(f(a, b)).epsilon(1e-15));
    REQUIRE(result.partial[0] == Catch::Approx((f(a + h, b) - f(a - h, b)) / (2 * h)).epsilon(1e-8).margin(1e-8));
    REQUIRE(result.partial[1] == Catch::Approx((f(a, b + h) - f(a, b - h)) / (2 * h)).epsilon(1e-8).margin(1e-8));
  }
}

}  // namespace

TEST_CASE("The derivative of every operation is that of central differences") {
  using zonal::select, zonal::minimum, zonal::maximum, zonal::abs, zonal::sqrt, zonal::exp;
  check_derivatives("-a", [](const auto& a, const auto&) { return -a; });
  check_derivatives("a+b", [](const auto& a, const auto& b) { return a + b; });
  check_derivatives("a-b", [](const auto& a, const auto& b) { return a - b; });
  check_derivatives("a*b", [](const auto& a, const auto& b) { return a * b; });
  check_derivatives("a/b", [](const auto& a, const auto& b) { return a / b; });
  check_derivatives("min", [](const auto& a, const auto& b) { return minimum(a, b) * b; });
  check_derivatives("max", [](const auto& a, const auto& b) { return maximum(a, b) * b; });
  check_derivatives("abs", [](const auto& a, const auto& b) { return abs(a) * b; });
  check_derivatives("sqrt", [](const auto& a, const auto& b) { return a * sqrt(b); });
  check_derivatives("exp", [](const auto& a, const auto& b) { return exp(a * b); });
  check_derivatives("<", [](const auto& a, const auto& b) { return select(a < b, a * a, b); });
  check_derivatives("<=", [](const auto& a, const auto& b) { return select(a <= b, a * a, b); });
  check_derivatives(">", [](const auto& a, const auto& b) { return select(a > b, a * a, b); });
  check_derivatives(">=", [](const auto& a, const auto& b) { return select(a >= b, a * a, b); });
  check_derivatives("asin", [](const auto& a, const auto& b) { return zonal::asin(a) * b; });
  check_derivatives("acos", [](const auto& a, const auto& b) { return zonal::acos(a) * b; });
}

TEST_CASE("A constant has no derivative, and duals nest for second derivatives") {
  CHECK(Dual2(3).partial == std::array<double, 2>{0, 0});
  using First = zonal::Dual<double, 1>;
  using Second = zonal::Dual<First, 1>;
  const Second x = Second::variable(First::variable(0.3, 0), 0);
  const Second y = x * x * x + exp(x) / sqrt(x);
  const double e = std::exp(0.3);
  CHECK(y.value.value == Catch::Approx(0.027 + e / std::sqrt(0.3)));
  CHECK(y.partial[0].value == Catch::Approx(0.27 + e * (std::pow(0.3, -0.5) - 0.5 * std::pow(0.3, -1.5))));
  CHECK(y.partial[0].partial[0] ==
        Catch::Approx(1.8 + e * (std::pow(0.3, -0.5) - std::pow(0.3, -1.5) + 0.75 * std::pow(0.3, -2.5))));
}

TEST_CASE("The derivatives of evaluate are those of central differences") {
  constexpr int N = 8;
  using D = zonal::Dual<double, 3>;
  const std::array<double, 3> v{0.36, -0.48, 0.8};
  const auto y = zonal::evaluate<N>(std::array<D, 3>{D::variable(v[0], 0), D::variable(v[1], 1), D::variable(v[2], 2)});
  const auto value = zonal::evaluate<N>(v);
  for (std::size_t k = 0; k < 3; ++k) {
    const double h = 1e-6;
    auto above = v, below = v;
    above[k] += h, below[k] -= h;
    const auto y_above = zonal::evaluate<N>(above), y_below = zonal::evaluate<N>(below);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(k, i);
      CHECK(y[i].value == Catch::Approx(value[i]).margin(1e-15));
      CHECK(y[i].partial[k] == Catch::Approx((y_above[i] - y_below[i]) / (2 * h)).epsilon(1e-8).margin(1e-8));
    }
  }
}

TEST_CASE("Shadow sees a cancellation") {
  using Shadow = zonal::Shadow<float, double>;
  const Shadow x = Shadow::input(std::exp2(-25.0F));
  const Shadow lost = (Shadow(1) + x) - Shadow(1);
  CHECK(lost.value == 0);
  CHECK(lost.error() == -std::exp2(-25.0));
  CHECK((x + x).error() == 0);
  CHECK(Shadow(0.1L).error() == Catch::Approx(static_cast<double>(0.1F) - 0.1).epsilon(1e-12));
  CHECK(minimum(Shadow(2), x).value == x.value);
  CHECK(maximum(Shadow(2), x).value == 2);
  CHECK(abs(-x).value == x.value);
  CHECK((x < Shadow(1)));
  CHECK(sqrt(Shadow(2)).error() == Catch::Approx(static_cast<double>(std::sqrt(2.0F)) - std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("The rounding error of evaluate, measured by its shadow, is below the promise") {
  constexpr int N = 10;
  using Shadow = zonal::Shadow<float, double>;
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const double scale = i % 2 ? 1 : 1e-4;  // half of them near a pole
    const double x = scale * normal(random), y = scale * normal(random), z = normal(random);
    const double length = std::sqrt(x * x + y * y + z * z);
    const auto input = [&](double c) { return Shadow::input(static_cast<float>(c / length)); };
    const auto values = zonal::evaluate<N>(std::array<Shadow, 3>{input(x), input(y), input(z)});
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        const double error = std::abs(values(l, m).error()) / std::sqrt((2 * l + 1) / (4 * 3.14159265358979323846));
        CAPTURE(x, y, z, l, m);
        REQUIRE(error <= accuracy_bound("evaluate", "float", N));
        worst = std::max(worst, error);
      }
    }
  }
  CHECK(worst > 1e-7);  // it does measure
}

TEST_CASE("evaluate runs in long double") {
  const std::array<long double, 3> v{0.36L, -0.48L, 0.8L};
  const auto wide = zonal::evaluate<10>(v);
  const auto narrow = zonal::evaluate<10>(std::array<double, 3>{0.36, -0.48, 0.8});
  for (int i = 0; i < 100; ++i) CHECK(narrow[i] == Catch::Approx(static_cast<double>(wide[i])).margin(2e-14));
}
