// Polygon lights: against quadrature over their surface, dual numbers, differences; how well the tolerance is held; and
// where they degenerate.
#include <zonal/light/triangle.hpp>
#include <zonal/lobe/cap.hpp>
#include <zonal/scalar/dual.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../catch.hpp"

namespace {

constexpr int N = 9;
constexpr double pi = 3.14159265358979323846;

/// By definition: the basis over the triangle's surface, solid angle by solid angle.
zonal::Sh<N, double> by_quadrature(const zonal::TriangleLight<double>& light, const glm::dvec3& x, int nodes = 60) {
  const auto rule = zonal::gauss_legendre(nodes);
  const glm::dvec3 a = light.vertices[0], ab = light.vertices[1] - a, bc = light.vertices[2] - light.vertices[1];
  const glm::dvec3 area = glm::cross(ab, bc);
  zonal::Sh<N, double> sum{};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const double u = (1 + rule.nodes[i]) / 2, v = (1 + rule.nodes[j]) / 2;
      const glm::dvec3 p = a + ab * u + bc * (u * v) - x;
      const double distance = glm::length(p);
      const double solid_angle = std::abs(glm::dot(area, p)) / (distance * distance * distance);
      sum += zonal::evaluate<N>(p / distance) * (rule.weights[i] * rule.weights[j] / 4 * u * solid_angle);
    }
  }
  return sum;
}

template <class Array>
double largest(const Array& values) {
  double result = 0;
  for (const auto& value : values) result = std::max(result, std::abs(static_cast<double>(value)));
  return result;
}

struct Random {
  std::mt19937 engine{51};
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  glm::dvec3 point(double low, double high) { return {(*this)(low, high), (*this)(low, high), (*this)(low, high)}; }
  zonal::TriangleLight<double> triangle(double size) {
    return {{glm::dvec3(0, 0, 2) + point(-size, size), glm::dvec3(0, 0, 2) + point(-size, size),
             glm::dvec3(0, 0, 2) + point(-size, size)}};
  }
};

template <class To, int V, class From>
zonal::PolygonLight<V, To> cast(const zonal::PolygonLight<V, From>& light) {
  zonal::PolygonLight<V, To> result;
  for (int v = 0; v < V; ++v) result.vertices[v] = glm::vec<3, To>(light.vertices[v]);
  return result;
}

/// The edges' formula in long double and at so many nodes that nothing is left to converge.
template <int Bands, int V, class T>
zonal::ShGradient<Bands, long double> converged(const zonal::PolygonLight<V, T>& light, const glm::vec<3, T>& x) {
  static const auto rule = zonal::gauss_legendre(64);
  zonal::ShGradient<Bands, long double> sh;
  const glm::vec<3, long double> wide(x);
  zonal::finish<Bands>(zonal::polygon_sums<Bands>(cast<long double>(light), rule, wide[0], wide[1], wide[2]),
                       zonal::detail::into(sh));
  return sh;
}

/// How a receiver sees a polygon, by plain geometry in double.
struct Geometry {
  double nearest_edge = 1e300;  // distance
  double outline = 0;           // radians
  double rounding = 0;          // sum over edges of arc (1 + distance of the nearer end / distance of the edge's line)
  double height = 1;            // over the plane, of the distance to the nearest vertex
  template <int V, class T>
  Geometry(const zonal::PolygonLight<V, T>& narrow, const glm::vec<3, T>& receiver) {
    const auto light = cast<long double>(narrow);
    const glm::vec<3, long double> x(receiver);
    glm::vec<3, long double> area(0);
    long double nearest_vertex = 1e300L, height_of_nearest = 0;
    for (int v = 0; v < V; ++v) area += glm::cross(light.vertices[v] - x, light.vertices[(v + 1) % V] - x);
    for (int v = 0; v < V; ++v) {
      const auto p = light.vertices[v] - x, q = light.vertices[(v + 1) % V] - x, d = q - p;
      const long double lp = glm::length(p), lq = glm::length(q), ld = glm::length(d);
      if (ld == 0) continue;
      const auto foot = p + d * std::clamp(-glm::dot(p, d) / (ld * ld), 0.0L, 1.0L);
      const long double arc = std::atan2(glm::length(glm::cross(p, d)), glm::dot(p, q));
      nearest_edge = std::min(nearest_edge, static_cast<double>(glm::length(foot)));
      outline += static_cast<double>(arc);
      rounding += static_cast<double>(arc * (1 + std::min(lp, lq) * ld / glm::length(glm::cross(p, d))));
      if (lp < nearest_vertex) nearest_vertex = lp, height_of_nearest = glm::dot(p, area);
    }
    height = static_cast<double>(std::abs(height_of_nearest) / (nearest_vertex * glm::length(area)));
  }
};

template <int Bands, class A, class B>
double largest_difference(const zonal::Sh<Bands, A>& a, const zonal::Sh<Bands, B>& b) {
  double result = 0;
  for (int i = 0; i < Bands * Bands; ++i) {
    result = std::max(result,
                      static_cast<double>(std::abs(static_cast<long double>(a[i]) - static_cast<long double>(b[i]))));
  }
  return result;
}
template <int Bands, class A, class B>
double largest_slope_difference(const zonal::ShGradient<Bands, A>& a, const zonal::ShGradient<Bands, B>& b) {
  double result = 0;
  for (int k = 0; k < 3; ++k) result = std::max(result, largest_difference(a.gradient[k], b.gradient[k]));
  return result;
}
template <int Bands, class T>
double largest_slope(const zonal::ShGradient<Bands, T>& sh) {
  return std::max({largest(sh.gradient[0]), largest(sh.gradient[1]), largest(sh.gradient[2])});
}

/// A triangle and a receiver of each kind that is hard in its own way.
struct Placement {
  zonal::TriangleLight<double> light;
  glm::dvec3 x;
};
constexpr const char* kinds[] = {"any", "edge-on", "sliver", "near an edge", "end-on"};
Placement place(Random& random, int kind) {
  const double size = std::pow(10.0, random(-2, 0.3));
  const glm::dvec3 centre = random.point(-0.5, 0.5) + glm::dvec3(0, 0, 2);
  Placement result{
      {{centre + random.point(-size, size), centre + random.point(-size, size), centre + random.point(-size, size)}},
      random.point(-0.6, 0.6)};
  auto& p = result.light.vertices;
  const auto on_edge = [&](double low, double high) { return p[0] + (p[1] - p[0]) * random(low, high); };
  if (kind == 1) {
    const glm::dvec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    result.x -= n * (glm::dot(result.x - p[0], n) * (1 - std::pow(10.0, random(-6, 0))));
  } else if (kind == 2) {
    p[2] = on_edge(-0.5, 1.5) + random.point(-size, size) * std::pow(10.0, random(-5, -1));
  } else if (kind == 3) {
    result.x = on_edge(-0.2, 1.2) + random.point(-size, size) * std::pow(10.0, random(-5, 0));
  } else if (kind == 4) {
    result.x = on_edge(1.05, 3) + random.point(-size, size) * std::pow(10.0, random(-4, -1));
  }
  return result;
}

}  // namespace

TEST_CASE("polygon: is the integral over its surface, to the tolerance asked for") {
  Random random;
  for (int trial = 0; trial < 60; ++trial) {
    const auto light = random.triangle(std::pow(10.0, -2 * (trial % 5) / 4.0));
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto expected = by_quadrature(light, x);
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const auto got = zonal::project<N>(light, x, tolerance);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(trial, tolerance, i, got[i], expected[i]);
        REQUIRE(std::abs(got[i] - expected[i]) <= tolerance * expected[0] + 1e-11 * largest(expected));
      }
    }
  }
}

TEST_CASE("polygon: the gradient is that of dual numbers, and of differences in long double") {
  Random random;
  const auto rule = zonal::gauss_legendre(24);
  using D = zonal::Dual<double, 3>;
  for (int trial = 0; trial < 30; ++trial) {
    const auto light = random.triangle(1);
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto got = zonal::project_with_gradient<N>(light, x, 1e-12);
    zonal::Sh<N, D> dual{};
    zonal::finish<N>(
        zonal::polygon_sums<N>(light, rule, D::variable(x[0], 0), D::variable(x[1], 1), D::variable(x[2], 2)),
        [&](auto l, auto m, const D& value, const D&, const D&, const D&) { dual(l, m) = value; });
    const auto wide = cast<long double>(light);
    for (int k = 0; k < 3; ++k) {
      glm::vec<3, long double> above(x), below(x);
      const long double h = 1e-6L;
      above[k] += h, below[k] -= h;
      const auto high = zonal::project<N>(wide, above, 1e-14), low = zonal::project<N>(wide, below, 1e-14);
      const double unit = largest(got.gradient[0]) + largest(got.gradient[1]) + largest(got.gradient[2]);
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(trial, k, i);
        REQUIRE(std::abs(got.gradient[k][i] - dual[i].partial[static_cast<std::size_t>(k)]) <= 1e-9 * unit);
        const double slope = static_cast<double>((high[i] - low[i]) / (2 * h));
        REQUIRE(std::abs(got.gradient[k][i] - slope) <= 1e-7 * unit);
      }
    }
  }
}

TEST_CASE("polygon: the tolerance is held, of coefficients and gradients, at all shapes") {
  Random random;
  for (int kind = 0; kind < 5; ++kind) {
    for (int trial = 0; trial < 150; ++trial) {
      const auto [light, x] = place(random, kind);
      const auto expected = converged<N>(light, x);
      const Geometry geometry(light, x);
      const double rounding = 1.1e-16 * geometry.rounding, c00 = static_cast<double>(expected.value[0]);
      for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
        const auto got = zonal::project_with_gradient<N>(light, x, tolerance);
        CAPTURE(kinds[kind], trial, tolerance, c00, geometry.nearest_edge);
        REQUIRE(largest_difference(got.value, expected.value) <= tolerance * c00 + 16 * rounding);
        const double slope_error = largest_slope_difference(got, expected),
                     slope_rounding = 40 * rounding / geometry.nearest_edge;
        REQUIRE(slope_error <= 4 * tolerance * c00 / geometry.nearest_edge + slope_rounding);
        REQUIRE(slope_error <= tolerance * largest_slope(expected) + slope_rounding);
      }
    }
  }
}

TEST_CASE("polygon: the nodes of an edge are enough, for any number of bands and any arc") {
  // The errors of all Y_l^m, m = -l .. l, together: their squares sum to (2l+1)/4pi times the same of P_l(cos(s - t)),
  // which is a sum of cos(k (s - t)) with the positive weights a_j a_(l-j), k = l - 2j. The factor 1/rho shifts k by 1.
  for (const int bands : {1, 2, 3, 5, 9, 21, 40, 80, 128}) {
    const int l = bands - 1;
    std::vector<double> a{1};
    for (int j = 1; j <= l; ++j) a.push_back(a.back() * (2 * j - 1) / (2 * j));
    for (const double arc : {1e-3, 0.1, 0.7, 1.5, 2.5, 3.14159}) {
      for (const double allowance : {1e-3, 1e-6, 1e-12}) {
        const int nodes = zonal::edge_nodes(bands, bands * arc, allowance);
        REQUIRE(nodes < zonal::most_edge_nodes);
        const auto& rule = zonal::edge_rule(nodes);
        REQUIRE(rule.nodes.size() >= static_cast<std::size_t>(nodes));
        const auto error = [&](int k) {  // of the integral of cos k s over the arc
          double sum = 0;
          for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            sum += rule.weights[i] * std::cos(k * rule.nodes[i] * arc / 2);
          }
          return std::abs(arc / 2 * sum - (k == 0 ? arc : 2 * std::sin(k * arc / 2) / k));
        };
        double plain = 0, shifted = 0;
        for (int j = 0; j <= l; ++j) {
          const double weight = a[static_cast<std::size_t>(j)] * a[static_cast<std::size_t>(l - j)];
          plain += weight * std::pow(error(std::abs(l - 2 * j)), 2);
          shifted += weight * std::pow((error(std::abs(l - 2 * j + 1)) + error(std::abs(l - 2 * j - 1))) / 2, 2);
        }
        const double unit = std::sqrt((2 * l + 1) / (4 * pi)), rounding = 1e-15 * unit;
        CAPTURE(bands, arc, allowance, nodes);
        REQUIRE(unit * std::sqrt(shifted) <= 4 * allowance * arc + rounding);
        // Of a coefficient, whose integrand is a gradient: at most sqrt(l(l+1)/2), over l(l+1).
        if (l > 0) REQUIRE(unit * std::sqrt(plain) / std::sqrt(2.0 * l * (l + 1)) <= allowance * arc + rounding);
      }
    }
  }
}

TEST_CASE("polygon: rounding in float, near and far, at every scale") {
  Random random;
  constexpr int M = 5;
  for (int kind = 0; kind < 5; ++kind) {
    for (int trial = 0; trial < 600; ++trial) {
      const double scale = trial % 2 == 0 ? 1 : std::pow(10.0, random(-12, 15));
      const auto [light, x] = place(random, kind);
      zonal::TriangleLight<float> narrow;
      for (int v = 0; v < 3; ++v) narrow.vertices[v] = glm::vec3(light.vertices[v] * scale);
      const glm::vec3 receiver(x * scale);
      const Geometry geometry(narrow, receiver);
      if (geometry.height < 1e-6) continue;  // on which side is a matter of rounding
      const auto expected = converged<M>(narrow, receiver);
      const auto got = zonal::project_with_gradient<M>(narrow, receiver, 1e-7);
      const double rounding = 6e-8 * geometry.rounding;
      CAPTURE(kinds[kind], trial, scale, geometry.nearest_edge / scale, geometry.height);
      REQUIRE(largest_difference(got.value, expected.value) <= 8 * rounding);
      REQUIRE(largest_slope_difference(got, expected) <= 16 * rounding / geometry.nearest_edge);
    }
  }
}

TEST_CASE("polygon: the scale does not matter, to the bit") {
  Random random;
  constexpr int M = 4;
  for (int trial = 0; trial < 40; ++trial) {
    const auto [light, x] = place(random, trial % 5);
    const auto narrow = cast<float>(light);
    const auto expected = zonal::project_with_gradient<M>(narrow, glm::vec3(x), 1e-6);
    for (const int exponent : {-36, -27, -1, 20, 31, 50}) {
      const float scale = std::ldexp(1.0F, exponent);
      zonal::TriangleLight<float> scaled = narrow;
      for (auto& vertex : scaled.vertices) vertex *= scale;
      const auto got = zonal::project_with_gradient<M>(scaled, glm::vec3(x) * scale, 1e-6);
      for (int i = 0; i < M * M; ++i) {
        CAPTURE(trial, exponent, i);
        REQUIRE(got.value[i] == expected.value[i]);
        for (int k = 0; k < 3; ++k) REQUIRE(got.gradient[k][i] * scale == expected.gradient[k][i]);
      }
    }
  }
}

TEST_CASE("polygon: just above an edge, in float") {
  constexpr int M = 5;
  const zonal::TriangleLight<float> light{{{-1, 0, 0}, {2, 0, 0}, {0.5F, 2, 0}}};
  for (const float height : {1e-2F, 1e-4F, 1e-6F, 1e-8F, 1e-12F, -1e-3F, -1e-8F}) {
    for (const float along : {-1.0F, -0.9F, 0.3F, 1.999F, 2.0F, 3.0F}) {
      const glm::vec3 x(along, 0, height);
      const auto expected = converged<M>(light, x);
      const auto got = zonal::project_with_gradient<M>(light, x);
      CAPTURE(height, along);
      CHECK(largest_difference(got.value, expected.value) <= 2e-6);
      CHECK(largest_slope_difference(got, expected) <= 2e-6 * largest_slope(expected));
    }
  }
}

namespace {

/// The light begun at each of its vertices, and each way around, is the same light.
template <int M, int V, class T>
void check_every_start(const zonal::PolygonLight<V, T>& light, const glm::vec<3, T>& x,
                       const zonal::ShGradient<M, long double>& expected, double tolerance) {
  for (int start = 0; start < V; ++start) {
    for (const int step : {1, V - 1}) {
      zonal::PolygonLight<V, T> turned;
      for (int v = 0; v < V; ++v) turned.vertices[v] = light.vertices[(start + step * v) % V];
      const auto got = zonal::project_with_gradient<M>(turned, x, tolerance / 100);
      CAPTURE(V, start, step, x.x, x.y, x.z);
      REQUIRE(largest_difference(got.value, expected.value) <= tolerance);
      REQUIRE(largest_slope_difference(got, expected) <= 4 * tolerance);
    }
  }
}

}  // namespace

TEST_CASE("polygon: collinear and repeated vertices change nothing, wherever it begins") {
  constexpr int M = 3;
  const zonal::TriangleLight<float> triangle{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  for (const glm::vec3& x :
       {glm::vec3(0, 0, 1), glm::vec3(0.2F, 0.1F, -1), glm::vec3(3, 2, 0.5F), glm::vec3(0, 5, -2)}) {
    const auto expected = converged<M>(triangle, x);
    for (const float middle : {-1.0F, std::nextafter(-1.0F, 0.0F), std::nextafter(-1.0F, -2.0F)}) {
      check_every_start<M>(zonal::PolygonLight<4, float>{{{-1, -1, 0}, {0, middle, 0}, {1, -1, 0}, {0, 1, 0}}}, x,
                           expected, 3e-6);
      check_every_start<M>(
          zonal::PolygonLight<6, float>{
              {{-1, -1, 0}, {-0.5F, middle, 0}, {0.25F, middle, 0}, {1, -1, 0}, {1, -1, 0}, {0, 1, 0}}},
          x, expected, 3e-6);
    }
    check_every_start<M>(zonal::PolygonLight<5, float>{{{-1, -1, 0}, {-1, -1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}},
                         x, expected, 3e-6);
    // There and back again: a spike without an area.
    check_every_start<M>(zonal::PolygonLight<5, float>{{{-1, -1, 0}, {1, -1, 0}, {3, 0.5F, 0}, {1, -1, 0}, {0, 1, 0}}},
                         x, expected, 5e-6);
  }
}

TEST_CASE("polygon: not convex, it is the sum of its triangles") {
  constexpr int M = 4;
  // An L and an arrow, tilted; a receiver in front, behind, over the notch, close by, and in the plane of the notch.
  const glm::dvec3 u(1, 0.2, 0.1), v(-0.1, 1, 0.3), n = glm::normalize(glm::cross(u, v));
  const auto at = [&](double a, double b) { return u * a + v * b; };
  const zonal::PolygonLight<6, double> l_shape{{at(0, 0), at(2, 0), at(2, 1), at(1, 1), at(1, 2), at(0, 2)}};
  const zonal::TriangleLight<double> l_parts[] = {{{at(0, 0), at(2, 0), at(2, 1)}},
                                                  {{at(0, 0), at(2, 1), at(1, 1)}},
                                                  {{at(0, 0), at(1, 1), at(0, 2)}},
                                                  {{at(1, 1), at(1, 2), at(0, 2)}}};
  const zonal::PolygonLight<4, double> arrow{{at(0.5, 1), at(0, 0), at(3, 1), at(0, 2)}};
  const zonal::TriangleLight<double> arrow_parts[] = {{{at(0.5, 1), at(0, 0), at(3, 1)}},
                                                      {{at(0.5, 1), at(3, 1), at(0, 2)}}};
  const auto check = [&](const auto& light, const auto& parts) {
    for (const glm::dvec3& x : {at(0.7, 0.7) + n * 1.0, at(1.6, 1.7) - n * 0.5, at(0.1, 1) + n * 0.2,
                                at(-3, 5) - n * 4.0, at(0.3, 1.1) + n * 0.02, at(1.5, 1.6) + n * 1e-9}) {
      zonal::ShGradient<M, long double> sum{};
      for (const auto& part : parts) {
        const auto one = converged<M>(part, x);
        sum.value += one.value;
        for (int k = 0; k < 3; ++k) sum.gradient[k] += one.gradient[k];
      }
      check_every_start<M>(light, x, sum, 1e-10 * (1 + largest_slope(sum)));
    }
  };
  check(l_shape, l_parts);
  check(arrow, arrow_parts);

  // On the surface, on the lines from the first vertex too, and in the notch beside it.
  for (int start = 0; start < 4; ++start) {
    zonal::PolygonLight<4, double> turned;
    for (int i = 0; i < 4; ++i) turned.vertices[i] = arrow.vertices[(start + i) % 4];
    for (const glm::dvec3& x : {at(1, 1), at(2, 1), at(1, 0.7), at(0.7, 1.5)}) {
      CAPTURE(start, x.x, x.y);
      CHECK(std::abs(zonal::project<1>(turned, x)[0] - std::sqrt(pi)) <= 1e-12);
    }
    for (const glm::dvec3& x : {at(0.2, 1), at(0.3, 1.1), at(-1, 1), at(4, 1)}) {
      CHECK(std::abs(zonal::project<1>(turned, x)[0]) <= 1e-12);
    }
    // Anywhere in the plane, to rounding, but on an edge.
    std::mt19937 random(59);
    std::uniform_real_distribution<double> uniform(-0.5, 3.5);
    for (int i = 0; i < 300; ++i) {
      const double p = uniform(random), q = uniform(random);
      const auto left_of = [&](double px, double py, double qx, double qy) {
        return (qx - px) * (q - py) - (qy - py) * (p - px);
      };
      const double sides[] = {left_of(0, 0, 3, 1), left_of(3, 1, 0, 2), left_of(0, 2, 0.5, 1), left_of(0.5, 1, 0, 0)};
      double nearest = 1;
      for (const double side : sides) nearest = std::min(nearest, std::abs(side));
      if (nearest < 1e-3) continue;
      // The arrow is its hull without the notch, the triangle that lies on the other side of both its inner edges.
      const bool is_inside = sides[0] > 0 && sides[1] > 0 && (sides[2] > 0 || sides[3] > 0);
      CAPTURE(start, p, q);
      CHECK(std::abs(zonal::project<1>(turned, at(p, q))[0] - (is_inside ? std::sqrt(pi) : 0)) <= 1e-9);
    }
  }
}

TEST_CASE("polygon: a quadrilateral is its two triangles, from any side and either way around") {
  const zonal::PolygonLight<4, double> square{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  const zonal::PolygonLight<4, double> turned{{{-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {-1, -1, 2}}};
  const zonal::TriangleLight<double> one{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}}},
      two{{{-1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  for (const glm::dvec3& x : {glm::dvec3(0.3, 0.2, 0), glm::dvec3(0.1, 3, 5), glm::dvec3(-4, 0, 1.9)}) {
    const auto whole = zonal::project_with_gradient<N>(square, x, 1e-10),
               back = zonal::project_with_gradient<N>(turned, x, 1e-10);
    const auto a = zonal::project_with_gradient<N>(one, x, 1e-10), b = zonal::project_with_gradient<N>(two, x, 1e-10);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(x.x, x.y, x.z, i);
      CHECK(std::abs(whole.value[i] - a.value[i] - b.value[i]) <= 1e-9);
      CHECK(std::abs(whole.value[i] - back.value[i]) <= 1e-12);
      for (int k = 0; k < 3; ++k) {
        CHECK(std::abs(whole.gradient[k][i] - a.gradient[k][i] - b.gradient[k][i]) <= 1e-8);
        CHECK(std::abs(whole.gradient[k][i] - back.gradient[k][i]) <= 1e-12);
      }
    }
  }
}

TEST_CASE("polygon: a hemisphere when it fills one, and a sphere's cap when it is round") {
  const zonal::PolygonLight<4, double> wall{{{-1e5, -1e5, 1}, {1e5, -1e5, 1}, {1e5, 1e5, 1}, {-1e5, 1e5, 1}}};
  const auto hemisphere = zonal::project<N>(zonal::SphericalCap<double>{0, 1});
  const auto sh = zonal::project<N>(wall, glm::dvec3(0, 0, 0), 1e-8);
  for (int l = 0; l < N; ++l) CHECK(std::abs(sh(l, 0) - hemisphere[l]) <= 1e-3);

  constexpr int sides = 96;
  zonal::PolygonLight<sides, double> disc;
  for (int v = 0; v < sides; ++v) {
    disc.vertices[v] = glm::dvec3(std::cos(2 * pi * v / sides), std::sin(2 * pi * v / sides), 2);
  }
  const auto round = zonal::project<N>(disc, glm::dvec3(0, 0, 0), 1e-8);
  const auto cap = zonal::project<N>(zonal::SphericalCap<double>::from_angle(std::atan(0.5)));
  for (int l = 0; l < N; ++l) CHECK(std::abs(round(l, 0) - cap[l]) <= 2e-3 * cap[1]);
}

TEST_CASE("polygon: in its plane zero; on the surface a hemisphere; on an edge and at a vertex finite") {
  const zonal::TriangleLight<float> light{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  const auto beside = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1));
  const auto above = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1 + 1e-3F));
  const auto below = zonal::project_with_gradient<N>(light, glm::vec3(2, 2, 1 - 1e-3F));
  CHECK(largest(beside.value) <= 1e-6);
  CHECK(largest(beside.gradient[2]) > 1e-3);
  for (int i = 0; i < N * N; ++i) CHECK(std::abs(above.value[i]) <= 1e-3F);
  CHECK(largest(below.value) > 1e-6);

  const auto hemisphere = zonal::project<N>(zonal::SphericalCap<float>{0, 1});
  const auto near = zonal::project<N>(light, glm::vec3(0.3F, 0.3F, 1 - 1e-4F));
  for (int l = 0; l < N; ++l) CHECK(std::abs(near(l, 0) - hemisphere[l]) <= 5e-3F);

  for (const glm::vec3& x : {glm::vec3(0, 0, 1), glm::vec3(0.5F, 0, 1), glm::vec3(0.25F, 0.75F, 1),
                             glm::vec3(0.3F, 0.3F, 1), glm::vec3(-1, 0, 1), glm::vec3(0.5F, 1e-20F, 1)}) {
    const auto sh = zonal::project_with_gradient<N>(light, x);
    CAPTURE(x.x, x.y, x.z);
    for (int i = 0; i < N * N; ++i) {
      CHECK(std::isfinite(sh.value[i]));
      CHECK(std::abs(sh.value[i]) <= 10);
      for (const auto& gradient : sh.gradient) CHECK(std::isfinite(gradient[i]));
    }
  }
}

TEST_CASE("polygon: finite wherever the receiver is, and dark without an area") {
  constexpr int M = 3;
  const auto check_finite = [](const auto& light, const auto& x) {
    const auto sh = zonal::project_with_gradient<M>(light, x);
    CAPTURE(x.x, x.y, x.z);
    for (int i = 0; i < M * M; ++i) {
      REQUIRE(std::isfinite(sh.value[i]));
      REQUIRE(std::abs(sh.value[i]) <= 4);
      for (const auto& gradient : sh.gradient) REQUIRE(std::isfinite(gradient[i]));
    }
    return largest(sh.value);
  };
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    // At vertices, on edges and on their lines, in the plane; of any size.
    const double size = std::pow(10.0, random(-30, 30));
    zonal::TriangleLight<float> light;
    for (auto& vertex : light.vertices) vertex = glm::vec3(random.point(-1, 1) * size);
    const glm::vec3 *const p = light.vertices, along = p[1] - p[0], across = p[2] - p[0];
    for (const glm::vec3& x : {p[0], p[1], p[2], p[0] + along * 0.5F, p[0] + along * 1.5F, p[0] - along * 1e-7F,
                               p[0] + along * 0.2F + across * 0.3F, p[0] - along + across * 3.0F, glm::vec3(0)}) {
      check_finite(light, x);
      check_finite(zonal::PolygonLight<4, float>{{p[0], p[0], p[1], p[2]}}, x);
      check_finite(zonal::PolygonLight<4, float>{{p[0], p[1], p[0], p[1]}}, x);
      check_finite(zonal::TriangleLight<float>{{p[0], p[1], p[1]}}, x);
      check_finite(zonal::TriangleLight<float>{{p[0], p[0], p[0]}}, x);
    }
  }
  for (const glm::vec3& x : {glm::vec3(0.2F, 0.3F, 0), glm::vec3(-1, 5, 3)}) {
    CHECK(check_finite(zonal::TriangleLight<float>{{{0, 0, 1}, {0, 0, 1}, {1, 0, 1}}}, x) <= 1e-6);
    CHECK(check_finite(zonal::TriangleLight<float>{{{1, 0, 1}, {1, 0, 1}, {1, 0, 1}}}, x) == 0);
    CHECK(check_finite(zonal::PolygonLight<4, float>{{{0, 0, 1}, {1, 0, 1}, {3, 0, 1}, {2, 0, 1}}}, x) <= 1e-6);
  }
}

TEST_CASE("triangle as a sphere: without an area it is dark, and finite wherever the receiver is") {
  constexpr int M = 3;
  const zonal::TriangleLight<float> flat[] = {
      {{{1, 1, 2}, {1, 1, 2}, {0, 1, 2}}}, {{{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}}, {{{0, 0, 2}, {1, 1, 2}, {2, 2, 2}}}};
  for (const auto& triangle : flat) {
    const auto light = zonal::TriangleSphereLight<float>::approximate(triangle);
    for (const glm::vec3& x : {glm::vec3(0), triangle.vertices[0], light.center, glm::vec3(3, -2, 1)}) {
      const auto sh = zonal::project_with_gradient<M>(light, x);
      for (int i = 0; i < M * M; ++i) {
        CAPTURE(x.x, x.y, x.z, i);
        CHECK(std::isfinite(sh.value[i]));
        if (x != light.center) CHECK(sh.value[i] == 0);
        for (const auto& gradient : sh.gradient) CHECK(std::isfinite(gradient[i]));
      }
    }
  }
  // Of any size, down to the least distance of a light (Sight), it looks the same.
  const zonal::TriangleLight<float> triangle{{{0.5F, 0.25F, 2}, {-0.5F, 0, 2.5F}, {0, 0.75F, 2}}};
  const auto expected = zonal::project<M>(zonal::TriangleSphereLight<float>::approximate(triangle), glm::vec3(0));
  for (const int exponent : {-25, -20, 20, 50}) {
    auto scaled = triangle;
    for (auto& vertex : scaled.vertices) vertex *= std::ldexp(1.0F, exponent);
    const auto got = zonal::project<M>(zonal::TriangleSphereLight<float>::approximate(scaled), glm::vec3(0));
    CAPTURE(exponent);
    for (int i = 0; i < M * M; ++i) CHECK(std::abs(got[i] - expected[i]) <= 1e-6F);
  }
}

TEST_CASE("triangle as a sphere: near the exact one when small, and its gradient is that of dual numbers") {
  Random random;
  using D = zonal::Dual<double, 3>;
  for (int trial = 0; trial < 50; ++trial) {
    const auto light = random.triangle(0.03);
    const auto sphere = zonal::TriangleSphereLight<double>::approximate(light);
    const glm::dvec3 x = random.point(-0.6, 0.6);
    const auto exact = zonal::project<N>(light, x), approximate = zonal::project<N>(sphere, x);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(trial, i);
      CHECK(std::abs(exact[i] - approximate[i]) <= 0.02 * largest(exact));
    }

    const auto got = zonal::project_with_gradient<N>(sphere, x);
    zonal::Sh<N, D> dual{};
    zonal::project<N>(sphere, D::variable(x[0], 0), D::variable(x[1], 1), D::variable(x[2], 2),
                      [&](auto l, auto m, const D& y) { dual(l, m) = y; });
    for (int i = 0; i < N * N; ++i) {
      for (int k = 0; k < 3; ++k) {
        CHECK(std::abs(got.gradient[k][i] - dual[i].partial[static_cast<std::size_t>(k)]) <= 1e-11);
      }
    }
  }
}
