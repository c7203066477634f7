// Convex polygon lights, exactly: integrals over the edges instead of the surface.
//
// The polygon of vertices p_i, seen from the receiver, is a spherical polygon Omega whose edges are great-circle arcs.
// By the divergence theorem, with -l(l+1) the eigenvalue of the Laplacian and n_e the edge's unit inward normal,
//
//   integral over Omega of Y_l^m = 1/(l(l+1)) sum over edges n_e . integral of grad Y_l^m ds,     l >= 1,
//
// and Omega / (2 sqrt(pi)) for l = 0. When the receiver moves, the point of an edge at distance rho moves by 1/rho, so
// the gradient is the sum over edges of n_e times the integral of Y_l^m / rho ds. Both need the basis only, at a few
// Gauss-Legendre nodes on each arc: the error falls geometrically with their number. Along n_e, across the direction,
// grad Y_l^m is the step down of basis/ladder.hpp alone, (2l+1) D[Y_(l-1)]: it is linear, and applied once, to the sum
// of all nodes.
//
// - The light shines to both sides. In its plane, beside the polygon, all coefficients are zero, and the gradient is
//   the one on the side that its vertices run around counterclockwise.
// - On the polygon it is a hemisphere, which side is up to rounding; the gradient is the limit on that side.
// - On an edge or a vertex the gradient is infinite: what comes back is finite, and large.
// In float the edges of a small light cancel: the error is about 2e-6 over its angular size, more for slender ones.
// Use double there, or TriangleSphereLight (triangle.hpp).
//
// [1] Wang and Ramamoorthi, Analytic spherical harmonic coefficients for polygonal area lights, SIGGRAPH 2018.
// [2] Wu et al., Analytic spherical harmonic gradients for real-time rendering with many polygonal area lights,
//     SIGGRAPH 2020.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "../basis/gradient.hpp"
#include "../scalar/math.hpp"
#include "../scalar/quadrature.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A planar convex polygon of radiance 1, to both sides. Several make a concave one, or a mesh.
template <int V, class T>
struct PolygonLight {
  static_assert(V >= 3, "a polygon has at least three vertices");
  glm::vec<3, T> vertices[static_cast<std::size_t>(V)];
};
template <class T>
using TriangleLight = PolygonLight<3, T>;

/// The sums over nodes that the coefficients of N bands are made of.
template <int N, class T>
struct PolygonSums {
  static constexpr int moment_bands = N > 1 ? N - 1 : 1;
  Sh<moment_bands, T> moment[3];  // n_e Y ds
  Sh<N, T> slope[3];              // n_e Y / rho ds
  T solid_angle;

  static ZONAL_INLINE constexpr PolygonSums zero() {
    PolygonSums sums;
    for (auto& sh : sums.moment) {
      for (T& value : sh.values) value = T(0);
    }
    for (auto& sh : sums.slope) {
      for (T& value : sh.values) value = T(0);
    }
    sums.solid_angle = T(0);
    return sums;
  }
};

namespace detail {

// 1 / max(x, tiny): infinities become large.
template <class T>
ZONAL_INLINE constexpr T safe_inverse(const T& x) {
  return T(1) / maximum(x, T(1e-30L));
}

// The cosine of the angle between two vectors.
template <class T>
ZONAL_INLINE constexpr T arc_cosine(const T (&p)[3], const T (&q)[3]) {
  return clamp(dot3(p, q) * safe_inverse(sqrt(dot3(p, p) * dot3(q, q))), T(-1), T(1));
}

// Integrals along an edge.
template <int N, class T>
struct EdgeIntegrals {
  T normal[3];                                   // unit, on the left of the edge as seen from the receiver
  Sh<PolygonSums<N, T>::moment_bands, T> along;  // Y ds
  Sh<N, T> by_distance;                          // Y / rho ds
};

// The edge from p to q = p + edge, relative to the receiver.
template <int N, class T>
ZONAL_INLINE constexpr void integrate_edge(const T (&p)[3], const T (&edge)[3], const T (&q)[3],
                                           const QuadratureRule& rule, EdgeIntegrals<N, T>& result) {
  // The plane of the arc: its normal from the edge itself, which is exact however small the light looks.
  T c[3], foot[3];
  cross3(p, edge, c);
  cross3(edge, c, foot);
  const T area2 = dot3(c, c), inverse_area = safe_inverse(sqrt(area2)), inverse_area2 = safe_inverse(area2);
  for (int i = 0; i < 3; ++i) result.normal[i] = c[i] * inverse_area;

  // The arc about its middle: u(s) = middle cos s + along sin s, |s| <= half.
  const T p_inverse = safe_inverse(sqrt(dot3(p, p))), q_inverse = safe_inverse(sqrt(dot3(q, q)));
  T middle[3], along[3];
  for (int i = 0; i < 3; ++i) middle[i] = p[i] * p_inverse + q[i] * q_inverse;
  const T length = sqrt(dot3(middle, middle)), length_inverse = safe_inverse(length);
  for (int i = 0; i < 3; ++i) middle[i] = middle[i] * length_inverse;
  cross3(result.normal, middle, along);
  const T cos_half = minimum(T(0.5L) * length, T(1));
  const T sin_half = minimum(sqrt(area2) * (p_inverse * q_inverse) * length_inverse, T(1));
  const T half = angle_from(cos_half, sin_half);

  // Nodes. 1 / rho is u . foot / |c|^2, foot being |edge|^2 times the foot of the perpendicular on the edge's line.
  for (T& value : result.along.values) value = T(0);
  for (T& value : result.by_distance.values) value = T(0);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const auto s = sin_cos(half * T(rule.nodes[k]));
    T u[3];
    for (int i = 0; i < 3; ++i) u[i] = middle[i] * s.cosine + along[i] * s.sine;
    const T weight = half * T(rule.weights[k]);
    const T weight_by_distance = weight * (dot3(u, foot) * inverse_area2);
    evaluate<N>(u[0], u[1], u[2], [&](auto l, auto m, const T& y) ZONAL_INLINE {
      constexpr int i = sh_index(l, m);
      if constexpr (l < PolygonSums<N, T>::moment_bands) add_product(result.along.values[i], weight, y);
      add_product(result.by_distance.values[i], weight_by_distance, y);
    });
  }
}

// Adds an edge times what a polygon's radiance is on its left, less that on its right: 1 or -1 for a polygon that runs
// counterclockwise or clockwise as seen from the receiver. A packet may hold several edges for each receiver.
template <int N, class Wide, class T>
ZONAL_INLINE constexpr void add_edge(const EdgeIntegrals<N, Wide>& edge, const Wide& jump, PolygonSums<N, T>& sums) {
  for (int k = 0; k < 3; ++k) {
    const Wide inward = edge.normal[k] * jump;
    for (int i = 0; i < edge.along.size(); ++i) add_product(sums.moment[k].values[i], inward, edge.along.values[i]);
    for (int i = 0; i < N * N; ++i) add_product(sums.slope[k].values[i], inward, edge.by_distance.values[i]);
  }
}

// tan(Omega/2) of a triangle as sine and cosine [van Oosterom and Strackee]; `volume` is p . (edge x edge'), signed.
template <class T>
ZONAL_INLINE constexpr T triangle_solid_angle(const T& volume, const T (&a)[3], const T (&b)[3], const T (&c)[3]) {
  const T la = sqrt(dot3(a, a)), lb = sqrt(dot3(b, b)), lc = sqrt(dot3(c, c));
  const T cosine = la * lb * lc + dot3(a, b) * lc + dot3(b, c) * la + dot3(c, a) * lb;
  const T inverse = safe_inverse(sqrt(volume * volume + cosine * cosine));
  return T(2) * angle_from(clamp(cosine * inverse, T(-1), T(1)), minimum(abs(volume) * inverse, T(1)));
}

// How large a polygon looks, and from which side: 1 where its vertices run counterclockwise as seen, else -1.
template <class T>
struct PolygonView {
  T solid_angle, side;
};

// The vertices as seen from a receiver, and the edges from each to the next, exact however far away.
template <int V, class T>
struct SeenPolygon {
  T p[static_cast<std::size_t>(V)][3], edge[static_cast<std::size_t>(V)][3];

  template <class S>
  ZONAL_INLINE constexpr SeenPolygon(const PolygonLight<V, S>& light, const T (&receiver)[3]) {
    for (int v = 0; v < V; ++v) {
      for (int i = 0; i < 3; ++i) {
        p[v][i] = T(light.vertices[v][i]) - receiver[i];
        edge[v][i] = T(light.vertices[(v + 1) % V][i] - light.vertices[v][i]);
      }
    }
  }
};

template <int V, class T>
ZONAL_INLINE constexpr PolygonView<T> view(const SeenPolygon<V, T>& polygon) {
  const auto& p = polygon.p;
  const auto& edge = polygon.edge;
  T normal[3];
  cross3(edge[0], edge[1], normal);
  PolygonView<T> result{T(0), select(dot3(p[0], normal) < T(0), T(-1), T(1))};
  T diagonal[3] = {edge[0][0], edge[0][1], edge[0][2]}, area[3];
  for (int v = 1; v + 1 < V; ++v) {  // a fan of triangles from the first vertex
    cross3(diagonal, edge[v], area);
    result.solid_angle = result.solid_angle + triangle_solid_angle(dot3(p[0], area), p[0], p[v], p[v + 1]);
    for (int i = 0; i < 3; ++i) diagonal[i] = diagonal[i] + edge[v][i];
  }
  return result;
}

}  // namespace detail

/// The polygon's sums at the receiver (x, y, z); `rule` serves every edge: see edge_nodes.
template <int N, int V, class S, class T>
ZONAL_INLINE constexpr PolygonSums<N, T> polygon_sums(const PolygonLight<V, S>& light, const QuadratureRule& rule,
                                                      const T& x, const T& y, const T& z) {
  const T receiver[3] = {x, y, z};
  const detail::SeenPolygon<V, T> seen(light, receiver);
  const detail::PolygonView<T> view = detail::view(seen);
  PolygonSums<N, T> sums = PolygonSums<N, T>::zero();
  for (int v = 0; v < V; ++v) {
    detail::EdgeIntegrals<N, T> integrals;
    detail::integrate_edge<N>(seen.p[v], seen.edge[v], seen.p[(v + 1) % V], rule, integrals);
    detail::add_edge<N>(integrals, view.side, sums);
  }
  sums.solid_angle = view.solid_angle;
  return sums;
}

/// Coefficients and gradient from the sums: sink(l, m, value, d/dx, d/dy, d/dz).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void finish(const PolygonSums<N, T>& sums, Sink&& sink) {
  Sh<N, T> value;
  value.values[0] = T(1 / (2 * constexpr_sqrt(kPi))) * sums.solid_angle;
  unroll<0, 3>([&](auto k) ZONAL_INLINE {
    detail::ladder<N, detail::SolidWeights>(sums.moment[k],
                                            [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
                                              if constexpr (l > 0) {
                                                const T component = k == 0 ? gx : k == 1 ? gy : gz;
                                                T& target = value.values[sh_index(l, m)];
                                                target = k == 0 ? component : target + component;
                                              }
                                            });
  });
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    unroll<-l, l + 1>([&](auto m) ZONAL_INLINE {
      constexpr int i = sh_index(l, m);
      const T result = l == 0 ? value.values[i] : T(1.0L / (l == 0 ? 1 : l * (l + 1))) * value.values[i];
      sink(l, m, result, sums.slope[0].values[i], sums.slope[1].values[i], sums.slope[2].values[i]);
    });
  });
}

/// The number of nodes per edge for N bands, arcs of at most `arc` radians, and an error of `tolerance` of the light's
/// largest coefficient: the least n for which Gauss's bound on a trigonometric polynomial of degree N is small enough.
/// An estimate: over random triangles of all shapes the worst error was 1.6 times the tolerance.
inline constexpr int most_edge_nodes = 32;
inline int edge_nodes(int bands, double arc, double tolerance) {
  // arc (N arc)^2n (n!)^4 / ((2n+1) ((2n)!)^3), against a light of the size arc^2 / 8.
  const double reach = bands * arc;
  double bound = 1;
  for (int n = 1; n < most_edge_nodes; ++n) {
    const double k = 2.0 * n;
    bound *= reach * reach * n * n * n * n / (k * k * k * (k - 1) * (k - 1) * (k - 1));
    if (bound / (2 * n + 1) <= tolerance * arc / 8) return n;
  }
  return most_edge_nodes;
}

/// The Gauss-Legendre rule of so many nodes, 1 to 32; all are made at the first call.
inline const QuadratureRule& edge_rule(int nodes) {
  static const std::vector<QuadratureRule> rules = [] {
    std::vector<QuadratureRule> all;
    for (int n = 1; n <= most_edge_nodes; ++n) all.push_back(gauss_legendre(n));
    return all;
  }();
  return rules[static_cast<std::size_t>(nodes - 1)];
}

/// The rules of edge_nodes for N bands and a tolerance, to look up by arc.
class EdgeRules {
 public:
  EdgeRules(int bands, double tolerance) {
    for (std::size_t i = 0; i < steps; ++i) {
      rules_[i] = &edge_rule(edge_nodes(bands, double(kPi) * static_cast<double>(i + 1) / steps, tolerance));
    }
  }
  /// 0 <= arc <= pi, in radians; what lies between two steps gets the rule of the larger.
  const QuadratureRule& for_arc(double arc) const {
    const auto step = static_cast<std::size_t>(arc * (steps / double(kPi)));
    return *rules_[step < steps ? step : steps - 1];
  }

 private:
  static constexpr std::size_t steps = 256;
  const QuadratureRule* rules_[steps];
};

/// The largest angle that an edge of the polygon subtends from the receiver.
template <int V, class T>
T largest_arc(const PolygonLight<V, T>& light, const glm::vec<3, T>& x) {
  const T receiver[3] = {x[0], x[1], x[2]};
  const detail::SeenPolygon<V, T> seen(light, receiver);
  T least_cosine = T(1);
  for (int v = 0; v < V; ++v) least_cosine = minimum(least_cosine, detail::arc_cosine(seen.p[v], seen.p[(v + 1) % V]));
  return acos(least_cosine);
}

/// Coefficients at the receiver x, and their gradient by its position, within `tolerance` of the largest coefficient.
template <int N, int V, class T>
ShGradient<N, T> project_with_gradient(const PolygonLight<V, T>& light, const glm::vec<3, T>& x,
                                       double tolerance = 1e-6) {
  const QuadratureRule& rule = edge_rule(edge_nodes(N, static_cast<double>(largest_arc(light, x)), tolerance));
  ShGradient<N, T> sh;
  finish<N>(polygon_sums<N>(light, rule, x[0], x[1], x[2]), detail::into(sh));
  return sh;
}
template <int N, int V, class T>
Sh<N, T> project(const PolygonLight<V, T>& light, const glm::vec<3, T>& x, double tolerance = 1e-6) {
  return project_with_gradient<N>(light, x, tolerance).value;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
