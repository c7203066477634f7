// What the values of the basis must satisfy.
#include <zonal/basis/bands.hpp>
#include <zonal/basis/evaluate.hpp>
#include <zonal/basis/polynomial.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "directions.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

/// The n nodes and weights of the Gauss-Legendre rule on -1 to 1.
struct GaussLegendre {
  std::vector<double> nodes, weights;
  explicit GaussLegendre(int n) {
    for (int i = 0; i < n; ++i) {
      long double x = std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 0;
      for (int step = 0; step < 8; ++step) {
        const auto p = legendre_polynomials(n + 1, x);
        const auto top = static_cast<std::size_t>(n);
        slope = n * (x * p[top] - p[top - 1]) / (x * x - 1);
        x -= p[top] / slope;
      }
      nodes.push_back(static_cast<double>(x));
      weights.push_back(static_cast<double>(2 / ((1 - x * x) * slope * slope)));
    }
  }
};

template <int N>
void check_against_polynomials() {
  for (const auto& v : directions_and_poles<double>(200, 7 + N)) {
    CAPTURE(N, v[0], v[1], v[2]);
    // In long double, for in double the powers of z lose more than evaluate does.
    const auto expected = zonal::reference::evaluate_polynomial<N>(Vector3<long double>{v[0], v[1], v[2]});
    const auto error = [](double value, long double exact) { return std::abs(static_cast<double>(value - exact)); };
    const auto all = zonal::evaluate<N>(v);
    const auto even = zonal::evaluate_even<N>(v[0], v[2]);
    const auto zonal = zonal::evaluate_zonal<N>(v[2]);
    for (int l = 0; l < N; ++l) {
      const double tolerance = 1e-14 * largest_of_degree(l);
      for (int m = -l; m <= l; ++m) {
        CAPTURE(l, m);
        REQUIRE(error(all(l, m), expected(l, m)) <= tolerance);
        if (m >= 0) REQUIRE(error(even(l, m), expected(l, m)) <= tolerance);
      }
      CAPTURE(l);
      REQUIRE(error(zonal[l], expected(l, 0)) <= tolerance);
    }
  }
}

}  // namespace

TEST_CASE("evaluate, evaluate_even and evaluate_zonal are the explicit polynomials, at each number of bands") {
  zonal::unroll<1, 11>([](auto n) { check_against_polynomials<n>(); });
}

TEST_CASE("Y_0 and Y_1 have the signs of the Condon-Shortley phase") {
  const auto v = normalized(0.3, -0.5, 0.7);
  const double k = std::sqrt(3 / (4 * pi));
  const auto check = [&](const zonal::Sh<2, double>& y) {
    CHECK(y(0, 0) == Catch::Approx(std::sqrt(1 / (4 * pi))).epsilon(1e-15));
    CHECK(y(1, -1) == Catch::Approx(-k * v[1]).epsilon(1e-15));
    CHECK(y(1, 0) == Catch::Approx(k * v[2]).epsilon(1e-15));
    CHECK(y(1, 1) == Catch::Approx(-k * v[0]).epsilon(1e-15));
  };
  check(zonal::evaluate<2>(v));
  check(zonal::reference::evaluate_polynomial<2>(v));
}

TEST_CASE("At the pole all but m = 0 vanish, exactly") {
  for (const float z : {1.0F, -1.0F}) {
    const auto y = zonal::evaluate<21>(Vector3<float>{0, 0, z});
    for (int l = 0; l < 21; ++l) {
      for (int m = -l; m <= l; ++m) {
        CAPTURE(z, l, m);
        if (m != 0) CHECK(y(l, m) == 0);
      }
    }
  }
}

TEST_CASE("evaluate, evaluate_even and evaluate_zonal agree, also where y is not 0") {
  for (const auto& v : directions_and_poles<double>(400, 11)) {
    const auto all = zonal::evaluate<21>(v);
    const auto mirrored = zonal::evaluate<21>(Vector3<double>{v[0], -v[1], v[2]});
    const auto even = zonal::evaluate_even<21>(v[0], v[2]);
    const auto zonal = zonal::evaluate_zonal<21>(v[2]);
    for (int l = 0; l < 21; ++l) {
      for (int m = 0; m <= l; ++m) {
        CAPTURE(l, m, v[0], v[1], v[2]);
        REQUIRE(std::abs(even(l, m) - all(l, m)) <= 1e-13 * largest_of_degree(l));
        REQUIRE(mirrored(l, m) == all(l, m));
        if (m > 0) REQUIRE(mirrored(l, -m) == -all(l, -m));
      }
      REQUIRE(std::abs(zonal[l] - all(l, 0)) <= 1e-14 * largest_of_degree(l));
    }
  }
}

TEST_CASE("The basis is orthonormal to 32 bands") {
  constexpr int N = 32, azimuths = 2 * N;
  const GaussLegendre rule(N);
  Eigen::MatrixXd samples(N * N, N * azimuths);
  for (int i = 0; i < N; ++i) {
    const double z = rule.nodes[static_cast<std::size_t>(i)], sine = std::sqrt((1 - z) * (1 + z));
    const double weight = rule.weights[static_cast<std::size_t>(i)] * 2 * pi / azimuths;
    for (int j = 0; j < azimuths; ++j) {
      const double phi = 2 * pi * (j + 0.5) / azimuths;
      const auto y = zonal::evaluate<N>(Vector3<double>{sine * std::cos(phi), sine * std::sin(phi), z});
      for (int k = 0; k < N * N; ++k) samples(k, i * azimuths + j) = std::sqrt(weight) * y[k];
    }
  }
  const Eigen::MatrixXd products = samples * samples.transpose() - Eigen::MatrixXd::Identity(N * N, N * N);
  Eigen::Index a = 0, b = 0;
  const double worst = products.cwiseAbs().maxCoeff(&a, &b);
  CAPTURE(a, b);
  CHECK(worst <= 1e-12);
}

TEST_CASE("Addition theorem: sum over m of Y(a) Y(b) is (2l+1)/(4 pi) P_l(a.b)") {
  constexpr int N = 21;
  const auto directions = directions_and_poles<double>(300, 13);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto& a = directions[i];
    const auto& b = directions[(7 * i + 3) % directions.size()];
    CAPTURE(a[0], a[1], a[2], b[0], b[1], b[2]);
    const auto ya = zonal::evaluate<N>(a), yb = zonal::evaluate<N>(b);
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const auto p = legendre_polynomials(N, static_cast<long double>(cosine));
    for (int l = 0; l < N; ++l) {
      double sum = 0;
      for (int m = -l; m <= l; ++m) sum += ya(l, m) * yb(l, m);
      const double scale = (2 * l + 1) / (4 * pi);
      CAPTURE(l, sum);
      REQUIRE(std::abs(sum - scale * static_cast<double>(p[static_cast<std::size_t>(l)])) <= 2e-13 * scale);
    }
  }
}

TEST_CASE("The sink receives each degree and order once, as constant expressions") {
  constexpr int N = 6;
  std::array<int, N * N> seen{};
  const auto v = normalized(0.2, 0.4, -0.6);
  const auto expected = zonal::evaluate<N>(v);
  zonal::evaluate<N>(v[0], v[1], v[2], [&](auto l, auto m, const double& value) {
    static_assert(0 <= l && l < N && -l <= m && m <= l);
    ++seen[static_cast<std::size_t>(zonal::sh_index(l, m))];
    // Not to the bit: the compiler may fuse additions with multiplications here and not there.
    CHECK(value == Catch::Approx(zonal::get<l, m>(expected)).epsilon(1e-14));
  });
  for (const int count : seen) CHECK(count == 1);

  int even = 0, zonal = 0;
  zonal::evaluate_even<N>(v[0], v[2], [&](auto l, auto m, const double&) {
    static_assert(0 <= m && m <= l && l < N);
    ++even;
  });
  zonal::evaluate_zonal<N>(v[2], [&](auto l, const double&) { CHECK(l == zonal++); });
  CHECK(even == N * (N + 1) / 2);
  CHECK(zonal == N);
}

TEST_CASE("Coefficients stand in the order l(l+1)+m, and in l(l+1)/2+m when only m >= 0 is stored") {
  int i = 0, even = 0;
  for (int l = 0; l < 30; ++l) {
    for (int m = -l; m <= l; ++m) {
      CAPTURE(l, m);
      CHECK(zonal::sh_index(l, m) == i++);
      if (m >= 0) CHECK(zonal::even_index(l, m) == even++);
    }
  }
  zonal::Sh<4, float> sh{};
  sh(3, -2) = 5;
  CHECK(sh[10] == 5);
  CHECK(zonal::get<3, -2>(sh) == 5);
  zonal::EvenSh<4, float> half{};
  half(3, 2) = 6;
  CHECK(half[8] == 6);
  CHECK(zonal::get<3, 2>(half) == 6);
  zonal::Zh<4, float> zh{};
  zh[3] = 7;
  CHECK(zonal::get<3>(zh) == 7);
  CHECK(sh.size() == 16);
  CHECK(half.size() == 10);
  CHECK(zh.size() == 4);
  STATIC_REQUIRE(std::is_trivially_copyable_v<zonal::Sh<4, float>>);
  STATIC_REQUIRE(sizeof(zonal::Sh<4, float>) == 16 * sizeof(float));
}

namespace {
// From 16 bands on arrays are evaluated with the orders in lanes: against the sink form, which is not, in long double.
template <int N, class T>
void check_many_bands() {
  const double bound = accuracy_of("evaluate", sizeof(T) == sizeof(float) ? "float" : "double", 21).bound;
  for (const auto& v : directions_and_poles<T>(1000, N)) {
    const auto y = zonal::evaluate<N>(v);
    double worst = 0;
    zonal::evaluate<N, long double>(v[0], v[1], v[2], [&](auto l, auto m, long double exact) {
      worst = std::max(worst, static_cast<double>(std::abs(y(l, m) - exact)) / largest_of_degree(l));
    });
    CAPTURE(N, v[0], v[1], v[2]);
    REQUIRE(worst <= bound);
  }
}
}  // namespace

TEST_CASE("Arrays of many bands: every value has its place, and is as exact as those of few") {
  check_many_bands<16, float>();
  check_many_bands<17, double>();
  check_many_bands<21, float>();
}

TEST_CASE("Arrays of many bands are constant expressions too") {
  constexpr auto y = zonal::evaluate<16>(std::array<double, 3>{0.48, 0.6, 0.64});
  const auto at_run_time = zonal::evaluate<16>(std::array<double, 3>{0.48, 0.6, 0.64});
  for (int i = 0; i < y.size(); ++i) CHECK(std::abs(y[i] - at_run_time[i]) <= 1e-13);
}

TEST_CASE("Coefficients form a vector space") {
  const auto a = zonal::evaluate<3>(normalized(1.0, 2.0, 3.0)), b = zonal::evaluate<3>(normalized(-3.0, 1.0, 0.5));
  const auto sum = a + b, difference = a - b, twice = a * 2.0;
  int count = 0;
  for (const double value : sum) {
    CHECK(value == a[count] + b[count]);
    ++count;
  }
  CHECK(count == 9);
  for (int i = 0; i < 9; ++i) {
    CHECK(difference[i] == a[i] - b[i]);
    CHECK(twice[i] == 2 * a[i]);
  }
}

TEST_CASE("dispatch_bands calls with the constant, and only in range") {
  for (int bands = -1; bands <= 12; ++bands) {
    CAPTURE(bands);
    int called = 0, given = 0;
    const bool found = zonal::dispatch_bands<2, 10>(bands, [&](auto n) {
      zonal::Zh<n, float> needs_a_constant{};
      given = needs_a_constant.bands;
      ++called;
    });
    const bool in_range = 2 <= bands && bands <= 10;
    CHECK(found == in_range);
    CHECK(called == (in_range ? 1 : 0));
    if (in_range) CHECK(given == bands);
  }
}

TEST_CASE("evaluate is a constant expression") {
  constexpr auto y = zonal::evaluate<3>(std::array<double, 3>{0, 0.6, 0.8});
  constexpr auto polynomial = zonal::reference::evaluate_polynomial<3>(std::array<double, 3>{0, 0.6, 0.8});
  STATIC_REQUIRE(y(1, 0) > 0);
  for (int i = 0; i < 9; ++i) CHECK(y[i] == Catch::Approx(polynomial[i]).margin(1e-15));
}
