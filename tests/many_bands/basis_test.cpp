// The basis of many bands and its gradient, against 34 digits.
#include <zonal/many_bands/evaluate.hpp>
#include <zonal/many_bands/gradient.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "directions.hpp"
#include "multiprecision.hpp"

namespace {

/// The greatest error met, in the unit of its row, and where.
struct Worst {
  double error = 0;
  int l = 0, m = 0;
  Vector3<double> direction{};

  template <class T>
  void meet(double e, int degree, int order, const Vector3<T>& at) {
    if (e > error || std::isnan(e)) {
      *this = {e, degree, order, {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])}};
    }
  }
};
#define CHECK_WORST(worst, bound)                                                          \
  do {                                                                                     \
    INFO("worst " << worst.error);                                                         \
    CAPTURE(worst.l, worst.m, worst.direction[0], worst.direction[1], worst.direction[2]); \
    CHECK(worst.error <= bound);                                                           \
    CHECK(worst.error >= bound / 20);                                                      \
  } while (false)

template <class T>
double difference(T value, const Wide& exact) {
  return std::abs(static_cast<double>(Wide(value) - exact));
}

/// Orders of all sizes, the first and the last among them.
std::vector<WideColumn> some_columns(int bands) {
  std::vector<WideColumn> columns;
  for (int m = 0; m < bands; m += m < 3 ? 1 : 1 + m / 3) columns.emplace_back(bands, m);
  if (columns.back().order() < bands - 1) columns.emplace_back(bands, bands - 1);
  return columns;
}

template <class T>
Worst basis_error(const zonal::ManyBands<T>& bands, const std::vector<WideColumn>& columns,
                  const std::vector<Vector3<T>>& directions) {
  Worst worst;
  zonal::BasisSpace<T> space(bands.bands());
  zonal::ManySh<T> y(bands.bands());
  for (const Vector3<T>& v : directions) {
    zonal::evaluate(bands, v, space, y.data());
    const WideVector exact = wide_direction(v);
    WidePower power;
    for (const WideColumn& column : columns) {
      const int m = column.order();
      column.visit(exact, power, [&](int l, const Wide& even, const Wide& odd) {
        worst.meet(difference(y(l, m), even) / largest_of_degree(l), l, m, v);
        if (m > 0) worst.meet(difference(y(l, -m), odd) / largest_of_degree(l), l, -m, v);
      });
    }
  }
  return worst;
}

template <class T>
void check_basis(int bands, int directions) {
  CAPTURE(scalar_name<T>, bands);
  const Worst worst =
      basis_error(zonal::ManyBands<T>(bands), some_columns(bands), directions_to_poles<T>(directions, 7));
  CHECK_WORST(worst, many_bands_bound("evaluate", scalar_name<T>, bands));
}

double steepest_of_degree(int l) { return largest_of_degree(l) * std::sqrt(l * (l + 1) / 2.0); }

/// By central differences of 34 digits.
template <class T>
Worst gradient_error(const zonal::ManyBands<T>& bands, const std::vector<WideColumn>& columns,
                     const std::vector<Vector3<T>>& directions) {
  const zonal::ManyGradient<T> ladder(bands);
  const Wide h = 1e-11;
  Worst worst;
  for (const Vector3<T>& v : directions) {
    const zonal::ManyShGradient<T> y = zonal::evaluate_with_gradient(bands, ladder, v);
    const zonal::ManySh<T>* const gradient[] = {&y.x, &y.y, &y.z};
    for (int axis = 0; axis < 3; ++axis) {
      WideVector before = wide_direction(v), after = before;
      before[static_cast<std::size_t>(axis)] -= h;
      after[static_cast<std::size_t>(axis)] += h;
      before = wide_direction(before);
      after = wide_direction(after);
      WidePower power_before, power_after;
      for (const WideColumn& column : columns) {
        const int m = column.order();
        std::vector<Wide> even, odd;
        column.visit(before, power_before,
                     [&](int, const Wide& a, const Wide& b) { even.push_back(a), odd.push_back(b); });
        column.visit(after, power_after, [&](int l, const Wide& a, const Wide& b) {
          if (l == 0) return;
          const auto i = static_cast<std::size_t>(l - m);
          const auto meet = [&](int order, const Wide& rise) {
            worst.meet(difference((*gradient[axis])(l, order), Wide(rise / (2 * h))) / steepest_of_degree(l), l, order,
                       v);
          };
          meet(m, a - even[i]);
          if (m > 0) meet(-m, b - odd[i]);
        });
      }
    }
  }
  return worst;
}

template <class T>
void check_gradient(int bands, int directions) {
  CAPTURE(scalar_name<T>, bands);
  const Worst worst =
      gradient_error(zonal::ManyBands<T>(bands), some_columns(bands), directions_to_poles<T>(directions, 11));
  CHECK_WORST(worst, many_bands_bound("evaluate_with_gradient", scalar_name<T>, bands));
}

}  // namespace

TEST_CASE("many bands: the basis against 34 digits, from equator to poles") {
  check_basis<float>(21, 200);
  check_basis<float>(190, 60);
  check_basis<float>(zonal::greatest_bands<float>, 30);
  check_basis<double>(21, 200);
  check_basis<double>(190, 30);
  check_basis<double>(1000, 24);
  check_basis<double>(zonal::greatest_bands<double>, 2);
}

TEST_CASE("many bands: the gradient against 34 digits, from equator to poles") {
  check_gradient<float>(21, 60);
  check_gradient<float>(190, 8);
  check_gradient<double>(190, 8);
  check_gradient<double>(1000, 2);
}

TEST_CASE("many bands: what is below the least normal number may be 0") {
#if defined(__SSE2__)
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);  // flush to zero, denormals are zero
  const auto check = [](auto scalar, int bands) {
    using T = decltype(scalar);
    CAPTURE(scalar_name<T>, bands);
    const zonal::ManyBands<T> constants(bands);
    const auto directions = directions_to_poles<T>(30, 13);
    std::vector<zonal::ManySh<T>> flushed, kept;
    for (const auto& v : directions) flushed.push_back(zonal::evaluate(constants, v));
    _mm_setcsr(_mm_getcsr() & ~0x8040U);
    for (const auto& v : directions) kept.push_back(zonal::evaluate(constants, v));
    _mm_setcsr(_mm_getcsr() | 0x8040);
    double worst = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (int k = 0; k < kept[i].size(); ++k) {
        worst = (std::max)(worst, static_cast<double>(std::abs(flushed[i][k] - kept[i][k])));
      }
    }
    return worst;
  };
  const double in_float = check(0.0F, zonal::greatest_bands<float>), in_double = check(0.0, 1000);
  _mm_setcsr(before);
  INFO("float " << in_float << ", double " << in_double);
  CHECK(in_float <= 2e-9);
  CHECK(in_double <= 1e-200);
#else
  WARN("skipped: no SSE2");
#endif
}

TEST_CASE("many bands: numbers of bands that cannot be are refused") {
  CHECK_THROWS_WITH(zonal::ManyBands<float>(zonal::greatest_bands<float> + 1),
                    "ManyBands: 251 bands; from 1 to 250 are possible");
  CHECK_THROWS_AS(zonal::ManyBands<double>(zonal::greatest_bands<double> + 1), std::invalid_argument);
  CHECK_THROWS_AS(zonal::ManyBands<double>(0), std::invalid_argument);
  CHECK_THROWS_AS(zonal::ManySh<float>(0), std::invalid_argument);
  CHECK_NOTHROW(zonal::ManyBands<float>(1));
}

// 10^4 directions, all orders: hours of one processor. ZONAL_DIRECTIONS is another number of them; all processors are
// used.
TEST_CASE("many bands: 1000 of them in double, all orders, many directions", "[.long]") {
  constexpr int bands = 1000;
  const char* const asked = std::getenv("ZONAL_DIRECTIONS");
  const auto directions = directions_to_poles<double>(asked ? std::stoi(asked) : 10000, 17);
  const zonal::ManyBands<double> constants(bands);
  const std::size_t threads = (std::max)(1U, std::thread::hardware_concurrency());
  std::vector<WideColumn> columns(bands, WideColumn(1, 0));
  std::vector<Worst> worst(threads);
  const auto on_threads = [&](const auto& body) {
    std::vector<std::thread> workers;
    for (std::size_t i = 0; i < threads; ++i) workers.emplace_back([&body, i] { body(i); });
    for (std::thread& worker : workers) worker.join();
  };
  on_threads([&](std::size_t i) {
    for (std::size_t m = i; m < columns.size(); m += threads) columns[m] = WideColumn(bands, static_cast<int>(m));
  });
  on_threads([&](std::size_t i) {
    std::vector<Vector3<double>> part;
    for (std::size_t k = i; k < directions.size(); k += threads) part.push_back(directions[k]);
    worst[i] = basis_error(constants, columns, part);
  });
  const Worst all = *std::max_element(worst.begin(), worst.end(), [](const Worst& a, const Worst& b) {
    return !(a.error >= b.error) && !std::isnan(a.error);
  });
  WARN("worst of " << directions.size() << " directions: " << all.error << " at l = " << all.l << ", m = " << all.m
                   << ", direction " << all.direction[0] << ' ' << all.direction[1] << ' ' << all.direction[2]);
  CHECK_WORST(all, many_bands_bound("evaluate", "double", bands));
}
