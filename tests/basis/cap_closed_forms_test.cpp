// The two slow references of the spherical cap, against the integral that defines them.
#include <zonal/lobe/cap_closed_form.hpp>
#include <zonal/lobe/cap_reference.hpp>

#include <cmath>

#include "../catch.hpp"
#include "directions.hpp"

TEST_CASE("The closed forms and the Legendre form of the cap are its integral") {
  constexpr int N = 10, intervals = 2000;
  for (const double c : {-1.0, -0.7, 0.0, 0.2, 0.5, 0.9, 0.99, 1.0}) {
    CAPTURE(c);
    // Simpson on the definition sqrt(pi (2l+1)) integral of P_l from c to 1.
    std::array<long double, N> integral{};
    for (int i = 0; i <= intervals; ++i) {
      const long double u = c + (1 - c) * i / intervals;
      const long double weight = (i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2) * (1 - c) / (3 * intervals);
      const auto p = legendre_polynomials(N, u);
      for (std::size_t l = 0; l < N; ++l) integral[l] += weight * p[l];
    }
    const auto closed = zonal::reference::project_cap_closed_form<N>(c);
    const auto legendre = zonal::reference::project_cap_legendre<N>(c);
    for (int l = 0; l < N; ++l) {
      CAPTURE(l);
      const double expected =
          std::sqrt(3.14159265358979323846 * (2 * l + 1)) * static_cast<double>(integral[static_cast<std::size_t>(l)]);
      CHECK(std::abs(closed[l] - expected) <= 2e-9);
      CHECK(std::abs(legendre[l] - expected) <= 2e-9);
      CHECK(std::abs(closed[l] - legendre[l]) <= 1e-14);
    }
  }
}
