// Gauss-Legendre rules: against weights computed in 113 bits, and by what they are made for.
#include <zonal/scalar/quadrature.hpp>

#include <cmath>
#include <limits>

#include "../catch.hpp"

TEST_CASE("gauss_legendre: the nodes and weights of large rules, next to the ends too") {
  // By the three-term recurrence and Newton's method in quadruple precision.
  struct Known {
    int size, index;
    double node, weight;
  };
  const Known known[] = {
      {1000, 0, -9.999971112980755106e-01, 7.413338416432071517e-06},
      {1000, 1, -9.999847796329174183e-01, 1.725676977373923012e-05},
      {1000, 2, -9.999625941483601533e-01, 2.711460656520585699e-05},
      {1000, 10, -9.994302211236081140e-01, 1.059721000990170972e-04},
      {1000, 100, -9.503748765069748906e-01, 9.768819084270615021e-04},
      {1000, 333, -4.993199488146149759e-01, 2.720570666705079603e-03},
      {1000, 499, -1.570010480083193829e-03, 3.140018380182867787e-03},
      {2048, 0, -9.999993109271053296e-01, 1.768383366666071181e-06},
      {2048, 1, -9.999963693177449578e-01, 4.116455830582225443e-06},
      {2048, 2, -9.999910771439723884e-01, 6.467995475736766624e-06},
      {2048, 10, -9.998640747849465112e-01, 2.528230318262615448e-05},
      {2048, 100, -9.880868993946861806e-01, 2.360170863444742186e-04},
      {2048, 682, -5.001106595257557143e-01, 1.328044029529440883e-03},
      {2048, 1023, -7.668030881472857683e-04, 1.533605875714330280e-03},
      {4096, 0, -9.999998276897038208e-01, 4.422038513909486725e-07},
      {4096, 1, -9.999990921074249848e-01, 1.029366140415132915e-06},
      {4096, 2, -9.999977687388967431e-01, 1.617397251702019287e-06},
      {4096, 10, -9.999660098225419554e-01, 6.322333732265028180e-06},
      {4096, 100, -9.970165486872825923e-01, 5.919522557907743676e-05},
      {4096, 1365, -4.998339490652416909e-01, 6.642255915386709865e-04},
      {4096, 2047, -3.834483770539112651e-04, 7.668967165215304047e-04},
  };
  for (const Known& k : known) {
    const auto rule = zonal::gauss_legendre(k.size);
    const auto i = static_cast<std::size_t>(k.index), mirrored = static_cast<std::size_t>(k.size) - 1 - i;
    CAPTURE(k.size, k.index, rule.nodes[i] - k.node, rule.weights[i] / k.weight - 1);
    CHECK(std::abs(rule.nodes[i] - k.node) <= 1e-15);
    CHECK(std::abs(rule.weights[i] - k.weight) <= 1e-13 * k.weight);
    CHECK(rule.nodes[mirrored] == -rule.nodes[i]);
    CHECK(rule.weights[mirrored] == rule.weights[i]);
  }
}

TEST_CASE("gauss_legendre: every weight is Christoffel's number, sizes 1 to 300") {
  // 1 / w = sum over l < size of (2l+1)/2 P_l(x)^2: all terms positive, and at the root hardly any slope by x.
  constexpr long double tolerance = std::numeric_limits<long double>::digits < 64 ? 1e-11L : 1e-13L;
  for (int size = 1; size <= 300; size += size < 40 ? 1 : 37) {
    const auto rule = zonal::gauss_legendre(size);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      long double x = static_cast<long double>(rule.nodes[i]), sum = 0;
      for (int iteration = 0; iteration < 3; ++iteration) {  // the node, to the last bit of long double
        long double before = 0, p = 1, slope = 0;
        sum = 0;
        for (int l = 0; l < size; ++l) {
          sum += (2 * l + 1) * p * p / 2;
          const long double next = ((2 * l + 1) * x * p - l * before) / (l + 1);
          slope = (l + 1) * p + x * slope;
          before = p;
          p = next;
        }
        x -= p / slope;
      }
      CAPTURE(size, i, rule.weights[i]);
      REQUIRE(std::abs(static_cast<long double>(rule.nodes[i]) - x) <= 1e-15L);
      REQUIRE(std::abs(static_cast<long double>(rule.weights[i]) * sum - 1) <= tolerance);
    }
  }
}

TEST_CASE("gauss_legendre: polynomials up to degree 2 size - 1 exactly, all sizes") {
  for (int size = 1; size <= 4096; size += size < 64 ? 1 : size) {
    const auto rule = zonal::gauss_legendre(size);
    REQUIRE(rule.nodes.size() == static_cast<std::size_t>(size));
    for (const int degree : {0, 2, size - size % 2, 2 * size - 2}) {
      if (degree > 2 * size - 1) continue;
      double sum = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        if (i > 0) REQUIRE(rule.nodes[i - 1] < rule.nodes[i]);
        sum += rule.weights[i] * std::cos(degree * std::acos(rule.nodes[i]));  // T_degree
      }
      CAPTURE(size, degree);
      REQUIRE(std::abs(sum - 2 / (1 - static_cast<double>(degree) * degree)) <= 2e-12);
    }
  }
}
