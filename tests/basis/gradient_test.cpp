// Gradients and Hessians of the basis: against 30 digits, dual numbers, central differences, and the papers' methods.
#include <zonal/basis/angular_gradient.hpp>
#include <zonal/basis/gradient.hpp>
#include <zonal/basis/polynomial_gradient.hpp>
#include <zonal/scalar/dual.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../csv.hpp"
#include "directions.hpp"

namespace {

// The gradient of Y(v/|v|) at any v != 0, in T.
template <int N, class T>
zonal::Sh<N, T> along_the_ray(const Vector3<T>& v) {
  using std::sqrt;
  const T length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return zonal::evaluate<N>(Vector3<T>{v[0] / length, v[1] / length, v[2] / length});
}

// The largest |gradient| of a harmonic of degree l: that of Y_l^1 at the pole.
double steepest_of_degree(int l) { return largest_of_degree(l) * std::max(1.0, std::sqrt(l * (l + 1) / 2.0)); }

template <int N, class T>
void check_table() {
  double worst = 0;
  for (const std::vector<double>& row : read_csv("basis.csv")) {
    const int l = static_cast<int>(row[3]), m = static_cast<int>(row[4]);
    if (l >= N) continue;
    const auto y = zonal::evaluate_with_gradient<N>(
        Vector3<T>{static_cast<T>(row[0]), static_cast<T>(row[1]), static_cast<T>(row[2])});
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = std::abs(static_cast<double>(y.gradient[k](l, m)) - row[6 + k]) / steepest_of_degree(l);
      CAPTURE(row[0], row[1], row[2], l, m, k, error);
      REQUIRE(std::isfinite(y.gradient[k](l, m)));
      worst = std::max(worst, error);
    }
    REQUIRE(std::abs(static_cast<double>(y.value(l, m)) - row[5]) <=
            accuracy_bound("evaluate", scalar_name<T>, 21) * largest_of_degree(l));
  }
  CAPTURE(N, scalar_name<T>, worst);
  CHECK(worst <= accuracy_bound("evaluate_with_gradient", scalar_name<T>, N));
}

}  // namespace

TEST_CASE("gradient: is as accurate as promised, against 30 digits, at the poles too") {
  check_table<10, float>();
  check_table<21, float>();
  check_table<21, double>();
}

TEST_CASE("gradient: is as accurate as promised in float, near the poles too") {
  constexpr double bound = accuracy_bound("evaluate_with_gradient", "float", 10);
  double worst = 0;
  for (const auto& v : directions_and_poles<float>(40000, 31)) {
    const auto y = zonal::evaluate_with_gradient<10>(v);
    const auto exact = zonal::evaluate_with_gradient<10>(normalized<long double>(v[0], v[1], v[2]));
    for (int l = 1; l < 10; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (std::size_t k = 0; k < 3; ++k) {
          const double error =
              static_cast<double>(std::abs(static_cast<long double>(y.gradient[k](l, m)) - exact.gradient[k](l, m)));
          worst = std::max(worst, error / steepest_of_degree(l));
          if (error <= bound * steepest_of_degree(l)) continue;  // an assertion for each would take most of the time
          CAPTURE(v[0], v[1], v[2], l, m, k, error);
          FAIL("beyond the bound");
        }
      }
    }
  }
  CHECK(worst >= bound / 10);
}

TEST_CASE("gradient and Hessian: are those of dual numbers, nested ones for the Hessian") {
  constexpr int N = 8;
  using First = zonal::Dual<double, 3>;
  using Second = zonal::Dual<First, 3>;
  const int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  for (const auto& v : directions_and_poles<double>(60, 32)) {
    Vector3<Second> seeds;
    for (int k = 0; k < 3; ++k) {
      seeds[static_cast<std::size_t>(k)] = Second::variable(First::variable(v[static_cast<std::size_t>(k)], k), k);
    }
    const auto dual = along_the_ray<N>(seeds);
    const auto y = zonal::evaluate_with_hessian<N>(v);
    const auto with_gradient = zonal::evaluate_with_gradient<N>(v);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(v[0], v[1], v[2], i);
      REQUIRE(std::abs(y.value[i] - dual[i].value.value) <= 1e-13);
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(std::abs(y.gradient[k][i] - dual[i].partial[k].value) <= 1e-12);
        REQUIRE(std::abs(y.gradient[k][i] - with_gradient.gradient[k][i]) <= 1e-13);
        for (std::size_t j = 0; j < 3; ++j) {
          REQUIRE(std::abs(y.hessian[index[j][k]][i] - dual[i].partial[k].partial[j]) <= 1e-11);
        }
      }
    }
  }
}

TEST_CASE("gradient: is that of central differences in long double") {
  constexpr int N = 10;
  for (const auto& v : directions_and_poles<long double>(60, 33)) {
    const auto y = zonal::evaluate_with_gradient<N>(v);
    for (std::size_t k = 0; k < 3; ++k) {
      const long double h = 1e-6L;
      auto above = v, below = v;
      above[k] += h, below[k] -= h;
      const auto high = along_the_ray<N>(above), low = along_the_ray<N>(below);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]), k, i);
        REQUIRE(std::abs(static_cast<double>(y.gradient[k][i] - (high[i] - low[i]) / (2 * h))) <= 1e-9);
      }
    }
  }
}

TEST_CASE("gradient: lies in the tangent plane, and |grad Y|^2 summed over a degree is l(l+1)(2l+1)/(4 pi)") {
  constexpr int N = 15;
  for (const auto& v : directions_and_poles<double>(200, 34)) {
    const auto y = zonal::evaluate_with_gradient<N>(v);
    for (int l = 0; l < N; ++l) {
      double sum = 0;
      for (int m = -l; m <= l; ++m) {
        double radial = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          radial += v[k] * y.gradient[k](l, m);
          sum += y.gradient[k](l, m) * y.gradient[k](l, m);
        }
        CAPTURE(l, m, v[0], v[1], v[2]);
        REQUIRE(std::abs(radial) <= 1e-12 * steepest_of_degree(l));
      }
      REQUIRE(sum == Catch::Approx(l * (l + 1) * largest_of_degree(l) * largest_of_degree(l)).epsilon(1e-12));
    }
  }
}

TEST_CASE("gradient: the papers' methods by angles agree with it away from the poles") {
  constexpr int N = 10;
  for (const auto& v : directions_and_poles<double>(400, 35)) {
    if (std::hypot(v[0], v[1]) < 0.05) continue;  // they divide by the square of it
    const auto expected = zonal::evaluate_with_gradient<N>(v);
    for (const auto& angular :
         {zonal::reference::angular_gradient_sloan_like<N>(v), zonal::reference::angular_gradient_direct<N>(v)}) {
      const auto y = zonal::reference::to_cartesian(angular, v);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(v[0], v[1], v[2], i);
        REQUIRE(std::abs(y.value[i] - expected.value[i]) <= 1e-13);
        for (std::size_t k = 0; k < 3; ++k) REQUIRE(std::abs(y.gradient[k][i] - expected.gradient[k][i]) <= 1e-11);
      }
    }
  }
}

namespace {

template <int N, class T>
void check_sink_form() {
  for (const auto& v : directions_and_poles<T>(300, 36)) {
    const auto rows = zonal::evaluate_with_gradient<N>(v);
    zonal::ShGradient<N, T> handed{};
    zonal::evaluate_with_gradient<N>(v[0], v[1], v[2],
                                     [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) {
                                       handed.value(l, m) = value;
                                       handed.gradient[0](l, m) = gx, handed.gradient[1](l, m) = gy;
                                       handed.gradient[2](l, m) = gz;
                                     });
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        const T unit = static_cast<T>(4 * steepest_of_degree(l)) * std::numeric_limits<T>::epsilon();
        CAPTURE(N, l, m, v[0], v[1], v[2]);
        REQUIRE(handed.value(l, m) == rows.value(l, m));
        for (int k = 0; k < 3; ++k) {
          REQUIRE(std::abs(handed.gradient[k](l, m) - rows.gradient[k](l, m)) <= unit);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("gradient: handed out one by one or computed a degree at a time, it is the same but for rounding") {
  zonal::unroll<1, 9>([](auto n) { check_sink_form<n, float>(); });
  check_sink_form<10, double>();
}

TEST_CASE("gradient: the explicit polynomials, differentiated, have the same part across the direction") {
  constexpr int N = 10;
  for (const auto& v : directions_and_poles<long double>(100, 37)) {
    const auto expected = zonal::evaluate_with_gradient<N>(v);
    const auto y = zonal::reference::across(zonal::reference::evaluate_polynomial_with_gradient<N>(v), v);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]), i);
      REQUIRE(std::abs(static_cast<double>(y.value[i] - expected.value[i])) <= 1e-15);
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(std::abs(static_cast<double>(y.gradient[k][i] - expected.gradient[k][i])) <= 1e-13);
      }
    }
  }
}
