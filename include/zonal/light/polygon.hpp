// Polygon lights, exactly: integrals over the edges instead of the surface.
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
// Any simple polygon, convex or not, of any vertices: collinear or repeated ones change nothing. All angles come from
// unit vectors, so that the scale does not matter: in float, distances and edges from 1e-15 to 1e18 units.
//
// - The light shines to both sides. In its plane, beside the polygon, all coefficients are zero, and the gradient is
//   the one on the side that its vertices run around counterclockwise.
// - On the polygon it is a hemisphere, which side is up to rounding; the gradient is the limit on that side.
// - On an edge or at a vertex the limit depends on the way there, and the gradient is infinite: what comes back is
//   finite, without that edge.
//
// Rounding, with u = 6e-8 in float and 1e-16 in double: 8 u times the sum over edges of arc (1 + r / h), where r is the
// distance of the edge's nearer end and h that of its line; of a gradient twice that over the distance to the nearest
// edge (5 bands; at 9 three times that; away from edges a tenth). So in float a light of angular size s is right to
// 3e-6 / s, a slender one less, and nearer than 1e-6 r to its plane the side is uncertain. Use double there, or
// TriangleSphereLight (triangle.hpp).
//
// [1] Wang and Ramamoorthi, Analytic spherical harmonic coefficients for polygonal area lights, SIGGRAPH 2018.
// [2] Wu et al., Analytic spherical harmonic gradients for real-time rendering with many polygonal area lights,
//     SIGGRAPH 2020.
// [3] van Oosterom and Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng. 30(2), 1983.
#pragma once

#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/gradient.hpp"
#include "../scalar/math.hpp"
#include "../scalar/quadrature.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A planar simple polygon of radiance 1, to both sides.
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

template <class T>
inline constexpr long double epsilon_v = static_cast<long double>(std::numeric_limits<lane_t<T>>::epsilon());
template <class T>
inline constexpr long double least_square_v = static_cast<long double>((std::numeric_limits<lane_t<T>>::min)());

template <class T>
ZONAL_INLINE constexpr T inverse_length(const T (&v)[3]) {
  return T(1) / sqrt(maximum(dot3(v, v), T(least_square_v<T>)));
}

// A point as seen from the receiver: unit vector and distance. Where the receiver is there, or out of range, it has no
// direction: unit vector and inverse distance are zero.
template <class T>
struct SeenPoint {
  T unit[3], distance, inverse_distance;

  ZONAL_INLINE static constexpr SeenPoint at(const T (&v)[3]) {
    const T least = T(least_square_v<T> / epsilon_v<T>), most = T(0.25L / least_square_v<T>), square = dot3(v, v);
    const auto is_here = square < least, is_beyond = most < square;
    SeenPoint point;
    point.distance = sqrt(clamp(square, least, most));
    point.inverse_distance = select(is_here, T(0), select(is_beyond, T(0), T(1) / point.distance));
    for (int i = 0; i < 3; ++i) point.unit[i] = v[i] * point.inverse_distance;
    return point;
  }
};

template <class T, class Mask>
ZONAL_INLINE constexpr SeenPoint<T> choose(const Mask& mask, const SeenPoint<T>& a, const SeenPoint<T>& b) {
  SeenPoint<T> point;
  for (int i = 0; i < 3; ++i) point.unit[i] = select(mask, a.unit[i], b.unit[i]);
  point.distance = select(mask, a.distance, b.distance);
  point.inverse_distance = select(mask, a.inverse_distance, b.inverse_distance);
  return point;
}
// Of two points the nearer, whose differences are exact longest.
template <class T>
ZONAL_INLINE constexpr SeenPoint<T> nearer(const SeenPoint<T>& p, const SeenPoint<T>& q) {
  return choose(p.distance < q.distance, p, q);
}

// The product of the unit vectors to the ends of an edge. From the edge itself it is exact however small it looks, or
// however near, and from the nearer end; edge over the farther distance, it has the length sin(arc).
template <class T>
ZONAL_INLINE constexpr void cross_of_ends(const SeenPoint<T>& p, const T (&edge)[3], const SeenPoint<T>& q,
                                          T (&result)[3]) {
  const T inverse_far = minimum(p.inverse_distance, q.inverse_distance);
  T scaled_edge[3];
  for (int i = 0; i < 3; ++i) scaled_edge[i] = edge[i] * inverse_far;
  cross3(nearer(p, q).unit, scaled_edge, result);
}

// The great-circle arc of an edge about its middle: u(s) = middle cos s + along sin s, |s| <= half; `normal` is on the
// left as seen from the receiver.
template <class T>
struct Arc {
  T normal[3], middle[3], along[3], cos_half, sin_half;
  mask_t<T> is_point;  // no arc: the edge points at the receiver, or ends there, up to rounding

  /// From p to q = p + edge.
  ZONAL_INLINE static constexpr Arc of(const SeenPoint<T>& p, const T (&edge)[3], const SeenPoint<T>& q) {
    Arc arc;
    T c[3];
    cross_of_ends(p, edge, q, c);
    const T inverse_sine = inverse_length(c);
    for (int i = 0; i < 3; ++i) arc.normal[i] = c[i] * inverse_sine;

    // p + q is 2 cos(half) times the middle, q - p is 2 sin(half) times what is along: the longer of the two is exact.
    const auto is_wide = dot3(p.unit, q.unit) < T(0);
    T longer[3], other[3];
    for (int i = 0; i < 3; ++i) longer[i] = q.unit[i] + select(is_wide, -p.unit[i], p.unit[i]);
    const T square = dot3(longer, longer), inverse = inverse_length(longer);
    for (int i = 0; i < 3; ++i) longer[i] = longer[i] * inverse;
    cross3(arc.normal, longer, other);
    const T other_square = dot3(other, other), other_inverse = inverse_length(other);
    for (int i = 0; i < 3; ++i) other[i] = other[i] * other_inverse;
    for (int i = 0; i < 3; ++i) {
      arc.middle[i] = select(is_wide, -other[i], longer[i]);
      arc.along[i] = select(is_wide, longer[i], other[i]);
    }
    const T long_half = minimum(T(0.5L) * square * inverse, T(1));
    const T short_half = minimum(dot3(c, c) * inverse_sine * inverse, T(1));
    // Where c is nothing but rounding, the normal may not even be across.
    arc.is_point = select(dot3(c, c) < T(least_square_v<T> / epsilon_v<T>), T(0), other_square) < T(0.25L);
    for (int i = 0; i < 3; ++i) arc.middle[i] = select(arc.is_point, T(i == 2 ? 1 : 0), arc.middle[i]);
    arc.cos_half = select(is_wide, short_half, long_half);
    arc.sin_half = select(is_wide, long_half, short_half);
    return arc;
  }
};

// Integrals along an edge.
template <int N, class T>
struct EdgeIntegrals {
  T normal[3];                                   // unit, on the left of the edge as seen from the receiver
  Sh<PolygonSums<N, T>::moment_bands, T> along;  // Y ds
  Sh<N, T> by_distance;                          // Y / rho ds
};

// The edge from p to q = p + edge. No 1 / rho counts for more than `most`, which limits the gradient beside the edge.
template <int N, class T>
ZONAL_INLINE constexpr void integrate_edge(const SeenPoint<T>& p, const T (&edge)[3], const SeenPoint<T>& q,
                                           const QuadratureRule& rule, const T& most, EdgeIntegrals<N, T>& result) {
  const Arc<T> arc = Arc<T>::of(p, edge, q);
  const T half = select(arc.is_point, T(0), angle_from(arc.cos_half, arc.sin_half));
  for (int i = 0; i < 3; ++i) result.normal[i] = arc.normal[i];

  // 1 / rho = level cos s + tilt sin s: what it is at both ends.
  const T least = T(epsilon_v<T> * epsilon_v<T>);
  const T level = T(0.5L) * (q.inverse_distance + p.inverse_distance) / maximum(arc.cos_half, least);
  const T tilt = T(0.5L) * (q.inverse_distance - p.inverse_distance) / maximum(arc.sin_half, least);

  for (T& value : result.along.values) value = T(0);
  for (T& value : result.by_distance.values) value = T(0);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const auto s = sin_cos(half * T(rule.nodes[k]));
    T u[3];
    for (int i = 0; i < 3; ++i) u[i] = arc.middle[i] * s.cosine + arc.along[i] * s.sine;
    const T weight = half * T(rule.weights[k]);
    const T weight_by_distance = weight * minimum(level * s.cosine + tilt * s.sine, most);
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

// The vertices as seen from a receiver, and the edges from each to the next, exact however far away.
template <int V, class T>
struct SeenPolygon {
  SeenPoint<T> vertex[static_cast<std::size_t>(V)];
  T edge[static_cast<std::size_t>(V)][3];

  template <class S>
  ZONAL_INLINE constexpr SeenPolygon(const PolygonLight<V, S>& light, const T (&receiver)[3]) {
    for (int v = 0; v < V; ++v) {
      T p[3];
      for (int i = 0; i < 3; ++i) {
        p[i] = T(light.vertices[v][i]) - receiver[i];
        edge[v][i] = T(light.vertices[(v + 1) % V][i] - light.vertices[v][i]);
      }
      vertex[v] = SeenPoint<T>::at(p);
    }
  }
};

// The solid angle of a triangle, positive where its vertices run counterclockwise as seen [3]:
//   tan(Omega/2) = a . (b x c) / (1 + a.b + b.c + c.a)
// - Of a small triangle the product is that of its exact edges with the nearest vertex.
// - Near an edge pq the sum is a small rest: 1 + p.q, and c . (p + q), of which w = p x q and d = q - p make, both
// times
//   2 (1 - p.q) = |d|^2,
//     c . ((d x w) x d) / (2 |w|^2 + 2 c . (d x w))
//   where nothing cancels. The widest edge is the one to take. Triangles that share an edge compute w alike, so that on
//   it, where w is rounding and each angle for itself means nothing, their sum is right.
template <class T>
ZONAL_INLINE constexpr T triangle_solid_angle(const SeenPoint<T>& a, const T (&ab)[3], const SeenPoint<T>& b,
                                              const T (&bc)[3], const SeenPoint<T>& c) {
  const T cos_ab = dot3(a.unit, b.unit), cos_bc = dot3(b.unit, c.unit), cos_ca = dot3(c.unit, a.unit);
  const auto is_bc = cos_bc < cos_ab, is_ca = cos_ca < minimum(cos_ab, cos_bc);
  const SeenPoint<T> p = choose(is_ca, a, choose(is_bc, b, a)), q = choose(is_ca, c, choose(is_bc, c, b));
  T edge[3], across[3], product[3], difference[3], turned[3], turned_back[3];
  for (int i = 0; i < 3; ++i) {
    edge[i] = select(is_ca, ab[i] + bc[i], select(is_bc, bc[i], ab[i]));
    across[i] = select(is_ca, b.unit[i], select(is_bc, a.unit[i], c.unit[i]));
    difference[i] = q.unit[i] - p.unit[i];
  }
  cross_of_ends(p, edge, q, product);
  cross3(difference, product, turned);
  cross3(turned, difference, turned_back);
  const T wide_volume = select(is_ca, -dot3(across, turned_back), dot3(across, turned_back));
  const T wide_rest = T(2) * (dot3(product, product) + dot3(across, turned));

  const SeenPoint<T> near = nearer(b, c);
  const T inverse_far = minimum(b.inverse_distance, c.inverse_distance);
  const T inverse_middle = minimum(a.inverse_distance, near.inverse_distance);
  T scaled_ab[3], scaled_bc[3], area[3];
  for (int i = 0; i < 3; ++i) scaled_ab[i] = ab[i] * inverse_middle, scaled_bc[i] = bc[i] * inverse_far;
  cross3(scaled_ab, scaled_bc, area);

  const auto is_wide = minimum(minimum(cos_ab, cos_bc), cos_ca) < T(0);
  const T volume = select(is_wide, wide_volume, dot3(nearer(a, near).unit, area));
  const T rest = select(is_wide, wide_rest, T(1) + cos_ab + cos_bc + cos_ca);
  const T inverse = T(1) / sqrt(maximum(volume * volume + rest * rest, T(least_square_v<T>)));
  const T half = angle_from(clamp(rest * inverse, T(-1), T(1)), minimum(abs(volume) * inverse, T(1)));
  return select(volume < T(0), T(-2), T(2)) * half;
}

// How large a polygon looks, and from which side: 1 where its vertices run counterclockwise as seen, else -1.
template <class T>
struct PolygonView {
  T solid_angle, side;
};

// As a fan of triangles from the first vertex, some of which are negative where the polygon is not convex: those that
// run around the other way. Of a receiver next to the plane each volume's sign is rounding; two triangles that it is in
// would add up to a sphere where they ought to cancel.
template <int V, class T>
ZONAL_INLINE constexpr PolygonView<T> view(const SeenPolygon<V, T>& polygon) {
  const auto& vertex = polygon.vertex;
  if constexpr (V == 3) {
    const T angle = triangle_solid_angle(vertex[0], polygon.edge[0], vertex[1], polygon.edge[1], vertex[2]);
    return {abs(angle), select(angle < T(0), T(-1), T(1))};
  }
  T inverse_longest = inverse_length(polygon.edge[0]);
  for (int v = 1; v < V; ++v) inverse_longest = minimum(inverse_longest, inverse_length(polygon.edge[v]));
  T diagonal[3] = {polygon.edge[0][0], polygon.edge[0][1], polygon.edge[0][2]}, normal[3] = {T(0), T(0), T(0)};
  T angle[static_cast<std::size_t>(V)], area[static_cast<std::size_t>(V)][3];
  T total = T(0), sum = T(0);
  for (int v = 1; v + 1 < V; ++v) {
    angle[v] = triangle_solid_angle(vertex[0], diagonal, vertex[v], polygon.edge[v], vertex[v + 1]);
    total = total + angle[v];
    T scaled_diagonal[3], scaled_edge[3];
    for (int i = 0; i < 3; ++i) {
      scaled_diagonal[i] = diagonal[i] * inverse_longest, scaled_edge[i] = polygon.edge[v][i] * inverse_longest;
      diagonal[i] = diagonal[i] + polygon.edge[v][i];
    }
    cross3(scaled_diagonal, scaled_edge, area[v]);
    for (int i = 0; i < 3; ++i) normal[i] = normal[i] + area[v][i];
  }
  for (int v = 1; v + 1 < V; ++v) {
    sum = sum + select(dot3(area[v], normal) < T(0), -abs(angle[v]), abs(angle[v]));
  }
  return {abs(sum), select(total < T(0), T(-1), T(1))};
}

// The arc between two seen points, in radians, or up to 3 % more: chord asin(x)/x, x = chord/2, where the rest of the
// series is convex in x^2, and so below the line between its ends.
template <class T>
ZONAL_INLINE constexpr T arc_bound(const SeenPoint<T>& p, const SeenPoint<T>& q) {
  T across[3];
  for (int i = 0; i < 3; ++i) across[i] = q.unit[i] - p.unit[i];
  const T square = dot3(across, across), x2 = T(0.25L) * square;
  constexpr long double rest = kPi / 2 - 1 - 1.0L / 6 - 3.0L / 40;
  return sqrt(square) * (T(1) + x2 * (T(1.0L / 6) + x2 * (T(3.0L / 40) + x2 * T(rest))));
}

// How far the integrands of an edge reach: its arc times their highest frequency. Along the arc, Y_l is a trigonometric
// polynomial of degree l < N, so that no derivative grows by more than l each time (Bernstein). 1/rho is
// cos(s - foot) / h: two derivatives leave it as large, and one multiplies it by at most
//   1, where the foot of the perpendicular is on the arc, and else min(1 / sin(arc), fall / arc + arc),
// where it falls from one end to the other by the part `fall` of its greatest value. A product grows by the sum.
template <int N, class T>
ZONAL_INLINE constexpr T edge_reach(const SeenPoint<T>& p, const SeenPoint<T>& q, const T& arc) {
  const T fall = T(1) - minimum(p.inverse_distance, q.inverse_distance) * minimum(p.distance, q.distance);
  return T(N - 1) * arc + maximum(arc, minimum(fall + arc * arc, T(kPi / 2)));
}

// Of a polygon: the length of its outline as seen, in radians, and the farthest reach of its edges.
template <class T>
struct Outline {
  T length, reach;
};
template <int N, int V, class T>
ZONAL_INLINE constexpr Outline<T> outline(const SeenPolygon<V, T>& polygon) {
  Outline<T> result{T(0), T(0)};
  for (int v = 0; v < V; ++v) {
    const auto &p = polygon.vertex[v], &q = polygon.vertex[(v + 1) % V];
    const T arc = arc_bound(p, q);
    result.length = result.length + arc;
    result.reach = maximum(result.reach, edge_reach<N>(p, q, arc));
  }
  return result;
}

}  // namespace detail

namespace detail {
template <int N, int V, class T>
ZONAL_INLINE constexpr PolygonSums<N, T> polygon_sums(const SeenPolygon<V, T>& seen, const PolygonView<T>& view,
                                                      const QuadratureRule& rule) {
  PolygonSums<N, T> sums = PolygonSums<N, T>::zero();
  for (int v = 0; v < V; ++v) {
    EdgeIntegrals<N, T> integrals;
    const T unlimited = T((std::numeric_limits<lane_t<T>>::max)());
    integrate_edge<N>(seen.vertex[v], seen.edge[v], seen.vertex[(v + 1) % V], rule, unlimited, integrals);
    add_edge<N>(integrals, view.side, sums);
  }
  sums.solid_angle = view.solid_angle;
  return sums;
}
}  // namespace detail

/// The polygon's sums at the receiver (x, y, z); `rule` serves every edge: see edge_nodes.
template <int N, int V, class S, class T>
ZONAL_INLINE constexpr PolygonSums<N, T> polygon_sums(const PolygonLight<V, S>& light, const QuadratureRule& rule,
                                                      const T& x, const T& y, const T& z) {
  const T receiver[3] = {x, y, z};
  const detail::SeenPolygon<V, T> seen(light, receiver);
  return detail::polygon_sums<N>(seen, detail::view(seen), rule);
}

namespace detail {

// 1/(l(l+1)) sum over k of (2l+1) D_k[moment_k] for l >= 1, m of either sign: the ladder's step down
// (basis/ladder.hpp), each coefficient by itself. (As three runs of ladder(), 21 bands took 20 s to compile.)
template <int l, int m, class T, int M>
ZONAL_INLINE constexpr T step_down(const Sh<M, T> (&moment)[3]) {
  constexpr int order = m < 0 ? -m : m, row = sh_index(l - 1, 0);
  constexpr long double weight = (2 * l + 1.0L) / (l * (l + 1)), keep = weight * keep_down(l, order),
                        raise = weight * raise_down(l, order), lower = order > 0 ? weight * lower_down(l, order) : 0;
  const T *const x = moment[0].values, *const y = moment[1].values, *const z = moment[2].values;
  T sum = T(0);
  if constexpr (order < l) sum = T(keep) * z[row + m];
  if constexpr (order + 1 < l) {
    sum = sum + T(raise) * x[row + (m < 0 ? m - 1 : m + 1)];
    sum = sum + T(m < 0 ? -raise : raise) * y[row + (m < 0 ? 1 - m : -m - 1)];
  }
  if constexpr (m != 0 && m != -1)
    sum = sum + T(lower) * x[row + (m < 0 ? m + 1 : m - 1)];  // sin(0 phi) is no harmonic
  if constexpr (m != 0 && m != 1) sum = sum + T(m < 0 ? lower : -lower) * y[row + (m < 0 ? -m - 1 : 1 - m)];
  return sum;
}

}  // namespace detail

/// The coefficients that the sums make. The gradient is their `slope`.
template <int N, class T>
ZONAL_INLINE constexpr void finish(const PolygonSums<N, T>& sums, Sh<N, T>& value) {
  constexpr auto constant = rounded<T>(1 / (2 * constexpr_sqrt(kPi)));
  value.values[0] = T(constant) * sums.solid_angle;
  unroll<1, N>([&](auto l) ZONAL_INLINE {
    unroll<-l, l + 1>([&](auto m)
                          ZONAL_INLINE { value.values[sh_index(l, m)] = detail::step_down<l, m>(sums.moment); });
  });
}
/// Coefficients and gradient from the sums: sink(l, m, value, d/dx, d/dy, d/dz).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void finish(const PolygonSums<N, T>& sums, Sink&& sink) {
  Sh<N, T> value;
  finish(sums, value);
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    unroll<-l, l + 1>([&](auto m) ZONAL_INLINE {
      constexpr int i = sh_index(l, m);
      sink(l, m, value.values[i], sums.slope[0].values[i], sums.slope[1].values[i], sums.slope[2].values[i]);
    });
  });
}

/// The most nodes of an edge: more than enough for 128 bands, whatever the arc and the tolerance.
inline constexpr int most_edge_nodes = 256;

/// The nodes that an edge needs for N <= 128 bands: the least n for which Gauss's bound on the error,
///   reach^2n (n!)^4 / ((2n+1) ((2n)!)^3) sqrt((2N-1) / 4 pi),
/// is at most 4 `allowance` per radian of arc and greatest 1/rho for the integral of Y_l^m / rho ds. A coefficient's
/// own error, whose integrand oscillates less and is divided by l(l+1), is then at most `allowance` per radian.
inline int edge_nodes(int bands, double reach, double allowance) {
  assert(1 <= bands && bands <= 128);
  double bound = std::sqrt((2 * bands - 1) / (4 * double(kPi)));
  for (int n = 1; n < most_edge_nodes; ++n) {
    const double odd = 2 * n - 1;
    bound *= reach * reach * n / (8 * odd * odd * odd);
    if (bound <= 4 * allowance * (2 * n + 1)) return n;
  }
  return most_edge_nodes;
}

/// The error that each radian of a polygon's outline may have: so that all together it is `tolerance` of the
/// coefficient of degree 0, and not less than rounding in T.
template <class T>
T edge_allowance(const T& solid_angle, const T& outline_length, double tolerance) {
  const T share = T(tolerance / (2 * std::sqrt(double(kPi)))) * solid_angle;
  return maximum(share / maximum(outline_length, T(detail::least_square_v<T>)), T(2 * detail::epsilon_v<T>));
}

/// What the nodes of a polygon's edges depend on, at a receiver: see edge_nodes. Of a packet, take the greatest reach
/// and the least allowance.
template <class T>
struct EdgeDemand {
  T reach, allowance;
};
template <int N, int V, class S, class T>
EdgeDemand<T> edge_demand(const PolygonLight<V, S>& light, double tolerance, const T& x, const T& y, const T& z) {
  const T receiver[3] = {x, y, z};
  const detail::SeenPolygon<V, T> seen(light, receiver);
  const detail::Outline<T> outline = detail::outline<N>(seen);
  return {outline.reach, edge_allowance(detail::view(seen).solid_angle, outline.length, tolerance)};
}

namespace detail {
inline std::vector<QuadratureRule> rules_of(int first, int last, int step) {
  std::vector<QuadratureRule> rules;
  for (int n = first; n <= last; n += step) rules.push_back(gauss_legendre(n));
  return rules;
}
}  // namespace detail

/// A Gauss-Legendre rule of so many nodes, 1 to 256; beyond 32, of up to 31 more. All up to 32 are made at the first
/// call, and the others at the first that asks for one.
inline const QuadratureRule& edge_rule(int nodes) {
  constexpr int most = 32;
  static const std::vector<QuadratureRule> rules = detail::rules_of(1, most, 1);
  if (nodes <= most) return rules[static_cast<std::size_t>(nodes - 1)];
  static const std::vector<QuadratureRule> large_rules = detail::rules_of(2 * most, most_edge_nodes, most);
  return large_rules[static_cast<std::size_t>((nodes - 1) / most - 1)];
}

namespace detail {
// Functions of their own: melted into one, 21 bands take twice as long to compile.
template <int N, int V, class T>
void set_sums(const SeenPolygon<V, T>& seen, const PolygonView<T>& view, const QuadratureRule& rule,
              PolygonSums<N, T>& sums) {
  sums = polygon_sums<N>(seen, view, rule);
}
template <int N, class T>
void set_coefficients(const PolygonSums<N, T>& sums, Sh<N, T>& value) {
  finish(sums, value);
}
}  // namespace detail

/// Coefficients at the receiver x, and their gradient by its position. Greatest error, next to rounding, with
/// e = `tolerance` times the coefficient of degree 0: of a coefficient e, of the gradient 4 e over the distance to the
/// nearest edge. (Seen: 0.03 e, and 0.15 `tolerance` of the largest gradient coefficient.)
template <int N, int V, class T>
ShGradient<N, T> project_with_gradient(const PolygonLight<V, T>& light, const glm::vec<3, T>& x,
                                       double tolerance = 1e-6) {
  const T receiver[3] = {x[0], x[1], x[2]};
  const detail::SeenPolygon<V, T> seen(light, receiver);
  const detail::PolygonView<T> view = detail::view(seen);
  const detail::Outline<T> outline = detail::outline<N>(seen);
  const T allowance = edge_allowance(view.solid_angle, outline.length, tolerance);
  const int nodes = edge_nodes(N, static_cast<double>(outline.reach), static_cast<double>(allowance));
  PolygonSums<N, T> sums;
  detail::set_sums(seen, view, edge_rule(nodes), sums);
  ShGradient<N, T> sh;
  detail::set_coefficients(sums, sh.value);
  for (int k = 0; k < 3; ++k) sh.gradient[k] = sums.slope[k];
  return sh;
}
template <int N, int V, class T>
Sh<N, T> project(const PolygonLight<V, T>& light, const glm::vec<3, T>& x, double tolerance = 1e-6) {
  return project_with_gradient<N>(light, x, tolerance).value;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
