// Anisotropic materials: their coefficients against plain sums, and the table that builds itself row by row.
#include <zonal/material/anisotropic_table.hpp>

#include <thread>

#include "../catch.hpp"
#include "tensor_writer.hpp"

using namespace material_test;

namespace {

constexpr int N = 6;
const zonal::ProjectionQuadrature& quadrature() {
  static const zonal::ProjectionQuadrature rules;
  return rules;
}

glm::dvec3 turned(const glm::dvec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// The definition, by the midpoint rule, in the frame where wo has the azimuth 0.
template <class F>
zonal::AnisotropicProjection<N> by_midpoints(const F& f, double degrees, double azimuth) {
  zonal::AnisotropicProjection<N> sum;
  midpoint_hemisphere(400, 800, [&](const glm::dvec3& wi, double solid_angle) {
    const glm::dvec3 value = f(turned(wi, azimuth), turned(outgoing(degrees), azimuth)) * solid_angle;
    const auto y = zonal::evaluate<N>(wi), below = zonal::evaluate<N>(glm::dvec3(wi.x, wi.y, -wi.z));
    for (int i = 0; i < N * N; ++i) {
      sum.with_cosine[i] += value * (wi.z * y[i]);
      sum.without_cosine[i] += value * (y[i] + below[i]);
    }
  });
  return sum;
}

}  // namespace

TEST_CASE("anisotropic: the projection is the definition's integral, both signs of m") {
  const Microfacets f{0.25, 0.6};
  for (const double degrees : {0.0, 35.0, 70.0}) {
    for (const double azimuth : {0.0, 0.7, 2.5, -1.2}) {
      const auto exact = by_midpoints(f, degrees, azimuth);
      const auto projection =
          zonal::project_anisotropic_brdf<N>(f, std::cos(degrees * pi / 180.0), azimuth, 1e-6, quadrature());
      CAPTURE(degrees, azimuth, projection.error);
      CHECK(projection.error <= 1e-6);
      CHECK(largest_difference(projection.with_cosine, exact.with_cosine) <=
            1e-4 * largest_coefficient(exact.with_cosine));
      CHECK(largest_difference(projection.without_cosine, exact.without_cosine) <=
            1e-4 * largest_coefficient(exact.without_cosine));
      if (azimuth == 0.7 && degrees == 35.0) {  // what only the odd part gives
        CHECK(largest(projection.with_cosine(2, -1)) > 0.01 * largest_coefficient(exact.with_cosine));
      }
    }
  }
}

TEST_CASE("anisotropic: an isotropic material has the coefficients of its own projection, and none of m < 0") {
  const Microfacets f{0.3, 0.3};
  for (const double degrees : {0.0, 50.0}) {
    const double cosine = std::cos(degrees * pi / 180.0);
    const auto even = zonal::project_brdf<N>(f, cosine, 1e-6, quadrature());
    for (const double azimuth : {0.0, 2.0}) {
      const auto projection = zonal::project_anisotropic_brdf<N>(f, cosine, azimuth, 1e-6, quadrature());
      for (int l = 0; l < N; ++l) {
        for (int m = 0; m <= l; ++m) {
          CAPTURE(degrees, azimuth, l, m);
          CHECK(largest(projection.with_cosine(l, m) - even.with_cosine(l, m)) < 1e-9);
          CHECK(largest(projection.without_cosine(l, m) - even.without_cosine(l, m)) < 1e-9);
          if (m > 0) CHECK(largest(projection.with_cosine(l, -m)) < 1e-9);
        }
      }
    }
  }
}

TEST_CASE("anisotropic table: rows are built when asked for, once, and half-way between them the stated bound holds") {
  const Microfacets f{0.2, 0.5};
  const zonal::AnisotropicTable table(f, N, 1e-3);
  CHECK(table.rows_built() == 0);
  int expected = 0;
  for (const double degrees : {0.5, 40.5, 75.5}) {
    for (const double azimuth : {0.5, 100.5, 359.5}) {
      const double radians = azimuth * pi / 180.0;
      const glm::vec3 wo(direction(degrees * pi / 180.0, radians));
      const auto exact =
          zonal::project_anisotropic_brdf<N>(f, std::cos(degrees * pi / 180.0), radians, 1e-4, quadrature());
      CAPTURE(degrees, azimuth);
      CHECK(largest_difference(table.with_cosine<N>(wo), exact.with_cosine) <=
            2e-3 * largest_coefficient(exact.with_cosine));
      CHECK(largest_difference(table.without_cosine<N>(wo), exact.without_cosine) <=
            2e-3 * largest_coefficient(exact.without_cosine));
      CHECK(largest_difference(table.with_cosine<N>(wo), table.with_cosine<N>(wo)) == 0.0);
      expected += azimuth == 359.5 ? 2 : 4;  // 359 and 0: the latter is there from 0.5
      CHECK(table.rows_built() == expected);
    }
  }
}

TEST_CASE("anisotropic table: threads that ask at once get the same rows") {
  const Microfacets f{0.4, 0.5};
  const zonal::AnisotropicTable table(f, 3, 1e-2);
  std::vector<zonal::Sh<3, glm::vec3>> results[3];
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&table, &result] {
      for (int i = 0; i < 30; ++i) result.push_back(table.with_cosine<3>(glm::vec3(direction(0.5 + 0.001 * i, 1.0))));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 30; ++i) {
    CAPTURE(i);
    CHECK(largest_difference(results[0][i], results[1][i]) == 0.0);
    CHECK(largest_difference(results[0][i], results[2][i]) == 0.0);
  }
}

TEST_CASE("anisotropic table: directions at the horizon, at the normal and on the seam of the azimuth") {
  const Microfacets f{0.4, 0.6};
  const zonal::AnisotropicTable table(f, 3, 1e-2);
  for (const glm::vec3 wo : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(-1, -0.0F, 0),
                             glm::vec3(0, -1, 0), glm::vec3(0.6F, -1e-9F, 0.8F), glm::vec3(std::nanf(""))}) {
    const auto sh = table.with_cosine<3>(wo);
    CAPTURE(wo.x, wo.y, wo.z);
    for (const glm::vec3& c : sh) CHECK((std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)));
    CHECK(sh(0, 0).x > 0.0F);
  }
  // f is its own image turned by pi
  const auto a = table.with_cosine<3>({0.6F, 0.0F, 0.8F}), b = table.with_cosine<3>({-0.6F, 0.0F, 0.8F});
  CHECK(largest_difference(a, b) <= 1e-5);
}
