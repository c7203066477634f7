// The basis of many bands and its gradient, against 34 digits.
#include <zonal/many_bands/evaluate.hpp>
#include <zonal/many_bands/gradient.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
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

template <class T, class Number>
double difference(T value, const Number& exact) {
  return std::abs(static_cast<double>(Number(Number(value) - exact)));
}

/// Orders of all sizes, the first and the last among them.
std::vector<WideColumn> some_columns(int bands) {
  std::vector<WideColumn> columns;
  for (int m = 0; m < bands; m += m < 3 ? 1 : 1 + m / 3) columns.emplace_back(bands, m);
  if (columns.back().order() < bands - 1) columns.emplace_back(bands, bands - 1);
  return columns;
}

template <class Number>
std::array<Number, 3> exact_direction(const Vector3<double>& v) {
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    return as_double_doubles(wide_direction(v));
  } else {
    return wide_direction(v);
  }
}
template <class Number>
std::array<Number, 3> exact_direction(const Vector3<float>& v) {
  return wide_direction(v);
}

template <class T, class Number>
Worst basis_error(const zonal::ManyBands<T>& bands, const std::vector<ColumnOf<Number>>& columns,
                  const std::vector<Vector3<T>>& directions) {
  Worst worst;
  zonal::BasisSpace<T> space(bands.bands());
  zonal::ManySh<T> y(bands.bands());
  for (const Vector3<T>& v : directions) {
    zonal::evaluate(bands, v, space, y.data());
    const std::array<Number, 3> exact = exact_direction<Number>(v);
    PowerOf<Number> power;
    for (const ColumnOf<Number>& column : columns) {
      const int m = column.order();
      column.visit(exact, power, [&](int l, const Number& even, const Number& odd) {
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

TEST_CASE("many bands: 31 digits of two doubles are good enough to test 1000 bands in double") {
  constexpr int bands = 1000;
  double worst = 0;
  std::vector<std::pair<WideColumn, ColumnOf<DoubleDouble>>> columns;
  for (const WideColumn& column : some_columns(bands)) columns.emplace_back(column, ColumnOf<DoubleDouble>(column));
  for (const Vector3<double>& v : directions_to_poles<double>(8, 19)) {
    const WideVector exact = wide_direction(v);
    const auto rounded = exact_direction<DoubleDouble>(v);
    WidePower wide_power;
    PowerOf<DoubleDouble> power;
    for (const auto& [wide, column] : columns) {
      std::vector<Wide> expected;
      wide.visit(exact, wide_power,
                 [&](int, const Wide& even, const Wide& odd) { expected.push_back(even), expected.push_back(odd); });
      std::size_t i = 0;
      column.visit(rounded, power, [&](int l, const DoubleDouble& even, const DoubleDouble& odd) {
        for (const DoubleDouble& found : {even, odd}) {
          const Wide error = abs(Wide(Wide(found.high) + Wide(found.low) - expected[i++]));
          const double e = static_cast<double>(error) / largest_of_degree(l);
          if (!(e <= worst)) worst = e;
        }
      });
    }
  }
  INFO("worst " << worst);
  CHECK(worst <= 1e-24);
}

// 10^4 directions, all orders: ten minutes of one processor. ZONAL_DIRECTIONS is another number of them.
TEST_CASE("many bands: 1000 of them in double, all orders, many directions", "[.long]") {
  constexpr int bands = 1000;
  const char* const asked = std::getenv("ZONAL_DIRECTIONS");
  const auto directions = directions_to_poles<double>(asked ? std::stoi(asked) : 10000, 17);
  std::vector<ColumnOf<DoubleDouble>> columns;
  for (int m = 0; m < bands; ++m) columns.emplace_back(WideColumn(bands, m));
  const Worst worst = basis_error(zonal::ManyBands<double>(bands), columns, directions);
  WARN("worst of " << directions.size() << " directions: " << worst.error << " at l = " << worst.l
                   << ", m = " << worst.m << ", direction " << worst.direction[0] << ' ' << worst.direction[1] << ' '
                   << worst.direction[2]);
  CHECK_WORST(worst, many_bands_bound("evaluate", "double", bands));
}
