// The greatest values, slopes and curvatures of band-limited functions against the functions themselves; and how the
// coefficients of a cap change with its size, against their integrals.
#include <zonal/basis/polynomial.hpp>
#include <zonal/lobe/cap_reference.hpp>
#include <zonal/many_lights/cluster_bound.hpp>

#include <cmath>

#include "../catch.hpp"
#include "patches.hpp"

using namespace many_lights_test;

namespace {

constexpr int bands = 6;
constexpr double pi = 3.14159265358979323846;
using Function = zonal::Sh<bands, glm::vec3>;

double value_at(const Function& f, const glm::dvec3& w) {
  const auto basis = zonal::reference::evaluate_polynomial<bands>(w);
  double sum = 0;
  for (int i = 0; i < f.size(); ++i) sum += double(f.values[i].x) * basis.values[i];
  return sum;
}

/// The greatest of value, first and second derivative along great circles, over many places.
struct Greatest {
  double value = 0, slope = 0, curvature = 0;
};
Greatest greatest_of(const Function& f, Random& random) {
  Greatest g;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 w(i < 100 ? glm::vec3(0, 0, 1) : random.direction());
    const glm::dvec3 along = glm::normalize(glm::cross(w, glm::dvec3(random.direction())));
    const double h = 1e-4;
    const auto at = [&](double angle) { return value_at(f, std::cos(angle) * w + std::sin(angle) * along); };
    const double before = at(-h), here = at(0), after = at(h);
    g.value = std::max(g.value, std::abs(here));
    g.slope = std::max(g.slope, std::abs(after - before) / (2 * h));
    g.curvature = std::max(g.curvature, std::abs(after - 2 * here + before) / (h * h));
  }
  return g;
}

}  // namespace

TEST_CASE("degree norms: no value, slope or curvature of a function is greater") {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    Function f{};
    for (auto& c : f.values) c = glm::vec3(random.uniform(-1, 1));
    const Greatest seen = greatest_of(f, random);
    CAPTURE(trial);
    CHECK(seen.value <= double(greatest_value(f).x) * (1 + 1e-6));
    CHECK(seen.slope <= double(greatest_slope(f).x) * (1 + 1e-6));
    CHECK(seen.curvature <= double(greatest_curvature(f).x) * (1 + 1e-5));
  }
}

TEST_CASE("degree norms: a zonal function of one degree has them, at its pole and where it is steepest") {
  Random random(2);
  for (int l = 1; l < bands; ++l) {
    Function zonal{}, steep{};
    zonal(l, 0) = steep(l, 1) = glm::vec3(1);  // Y_l^1 has no value at the pole, and of all the greatest slope
    CAPTURE(l);
    const Greatest at_pole = greatest_of(zonal, random);
    CHECK(at_pole.value == Catch::Approx(double(greatest_value(zonal).x)).epsilon(1e-5));
    CHECK(greatest_of(steep, random).slope == Catch::Approx(double(greatest_slope(steep).x)).epsilon(0.01));
  }
}

TEST_CASE("cluster bound: the coefficients of a cap over its sine squared change no faster than stated") {
  // e_l by the integral of P_l over the cap, between caps up to the greatest.
  const auto e = [](int l, double sine2) {
    const double cosine = std::sqrt(1 - sine2);
    const auto zh = zonal::reference::project_cap_legendre<21>(static_cast<long double>(cosine));
    return static_cast<double>(zh[l]) * std::sqrt(4 * pi / (2 * l + 1)) / pi / sine2;
  };
  const double widest = double(zonal::detail::widest_sine * zonal::detail::widest_sine);
  for (int l = 0; l < 21; ++l) {
    const int steps = 200;
    double greatest = 0;
    for (int i = 1; i < steps; ++i) {
      const double a = widest * i * i / (steps * steps), b = widest * (i + 1) * (i + 1) / (steps * steps);
      greatest = std::max(greatest, std::abs(e(l, b) - e(l, a)) / (b - a));
    }
    CAPTURE(l, greatest);
    CHECK(greatest <= double(zonal::detail::widening_of_degree(l)) + 1e-6);
    CHECK(double(zonal::detail::widening_of_degree(l)) <= 1.05 * greatest + 0.26);
  }
}
