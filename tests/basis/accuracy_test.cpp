// The promises of the accuracy table for the basis.
#include <zonal/basis/evaluate.hpp>

#include <algorithm>
#include <cmath>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../csv.hpp"
#include "directions.hpp"

namespace {

/// The greatest error met, in units of the largest value of the degree, and where.
struct Worst {
  double error = 0;
  int l = 0, m = 0;
  Vector3<double> direction{};

  void meet(double difference, int degree, int order, const Vector3<double>& at) {
    const double e = std::abs(difference) / largest_of_degree(degree);
    if (e > error || std::isnan(e)) *this = {e, degree, order, at};
  }
};

#define CHECK_WORST(worst, bound)                                                          \
  do {                                                                                     \
    CAPTURE(worst.l, worst.m, worst.direction[0], worst.direction[1], worst.direction[2]); \
    CHECK(worst.error <= bound);                                                           \
  } while (false)

template <class T>
Vector3<double> to_double(const Vector3<T>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Against 30 digits, at directions rounded to T.
template <int N, class T>
Worst against_table() {
  Worst worst;
  for (const std::vector<double>& row : read_csv("basis.csv")) {
    const int l = static_cast<int>(row[3]), m = static_cast<int>(row[4]);
    if (l >= N) continue;
    const auto y =
        zonal::evaluate<N>(Vector3<T>{static_cast<T>(row[0]), static_cast<T>(row[1]), static_cast<T>(row[2])});
    worst.meet(static_cast<double>(y(l, m)) - row[5], l, m, {row[0], row[1], row[2]});
  }
  return worst;
}

struct Comparison {
  Worst all, even, zonal;
};

/// Against long double at the direction that T has, normalised.
template <int N, class T>
Comparison against_long_double(int count) {
  Comparison worst;
  for (const Vector3<T>& v : directions_and_poles<T>(count, 20260725)) {
    const auto exact = zonal::evaluate<N>(normalized<long double>(v[0], v[1], v[2]));
    const auto exact_zonal = zonal::evaluate_zonal<N>(static_cast<long double>(v[2]));
    const auto y = zonal::evaluate<N>(v);
    const auto even = zonal::evaluate_even<N>(v[0], v[2]);
    const auto zonal = zonal::evaluate_zonal<N>(v[2]);
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        worst.all.meet(static_cast<double>(static_cast<long double>(y(l, m)) - exact(l, m)), l, m, to_double(v));
      }
      for (int m = 0; m <= l; ++m) {
        worst.even.meet(static_cast<double>(static_cast<long double>(even(l, m)) - exact(l, m)), l, m, to_double(v));
      }
      worst.zonal.meet(static_cast<double>(static_cast<long double>(zonal[l]) - exact_zonal[l]), l, 0, to_double(v));
    }
  }
  return worst;
}

template <int N, class T>
void check_promises(int count) {
  CAPTURE(scalar_name<T>, N);
  const Comparison worst = against_long_double<N, T>(count);
  const auto bound = [](std::string_view function) { return accuracy_bound(function, scalar_name<T>, N); };
  INFO("evaluate " << worst.all.error << ", even " << worst.even.error << ", zonal " << worst.zonal.error);
  CHECK_WORST(worst.all, bound("evaluate"));
  CHECK_WORST(worst.even, bound("evaluate_even"));
  CHECK_WORST(worst.zonal, bound("evaluate_zonal"));
  // A promise far above what is measured tells the reader nothing.
  CHECK(worst.all.error > bound("evaluate") / 20);
}

}  // namespace

TEST_CASE("evaluate is as accurate as promised, against 30 digits") {
  const Worst f10 = against_table<10, float>(), f21 = against_table<21, float>(), d21 = against_table<21, double>();
  CHECK_WORST(f10, accuracy_bound("evaluate", "float", 10));
  CHECK_WORST(f21, accuracy_bound("evaluate", "float", 21));
  CHECK_WORST(d21, accuracy_bound("evaluate", "double", 21));
}

TEST_CASE("evaluate is as accurate as promised in float, near the poles too") {
  check_promises<5, float>(40000);
  check_promises<10, float>(40000);
  check_promises<21, float>(40000);
}

TEST_CASE("evaluate is as accurate as promised in double") { check_promises<21, double>(4000); }
