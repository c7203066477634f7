// The spherical harmonics coefficients of a BRDF seen from one outgoing direction.
//
// Fixing wo leaves a function of wi alone, which is projected on the basis [1, 2]:
//
//   F_l^m  = integral of f(wi, wo) max(wi.z, 0) Y_l^m(wi)   "with cosine", for the receiver of light
//   F'_l^m = integral of f(wi, wo) Y_l^m(wi)                "without cosine", for a virtual light, whose geometric
//                                                           factor holds the cosine [2, 5.1]
//
// The frame has z = normal and wo in the plane y = 0 with wo.x >= 0. There an isotropic BRDF is even in phi: only
// m >= 0 is computed and stored.
//
// F' is never asked for below the horizon, so what f is taken to be there is free. [2] has zero, which makes a step of
// every diffuse material: one band gives half the light, three bands 16 % error. Here f is mirrored, f(x, y, |z|): a
// diffuse material is one band exactly, and all coefficients of odd l+m vanish, so that half of them do as much.
// Measured over the hemisphere, times the cosine, the error at 5 bands is 0.04 where it was 0.11 (plastic from the
// normal), 0.10 for 0.18 (GGX 0.5 at 60 degrees); equal for lobes too sharp for the bands.
//
// [1] Kautz, Sloan, Snyder, Fast, arbitrary BRDF shading for low-frequency lighting using spherical harmonics,
//     EGWR 2002.
// [2] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022, sections 4.2 and 5.1.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

#include "../basis/evaluate.hpp"
#include "brdf_projection.hpp"
#include "mirror_nodes.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

inline double largest(const glm::dvec3& rgb) { return (std::max)({std::abs(rgb.x), std::abs(rgb.y), std::abs(rgb.z)}); }

template <class Coefficients>
double largest(const Coefficients& sh) {
  double result = 0.0;
  for (const glm::dvec3& coefficient : sh) result = (std::max)(result, largest(coefficient));
  return result;
}

template <class Coefficients>
double relative_movement(const Coefficients& from, const Coefficients& to) {
  const double scale = largest(to);
  return scale > 0.0 ? largest(to - from) / scale : largest(from);
}

/// The projection of a sum of two BRDFs. Their errors add up before they are set against the larger
/// coefficients.
template <int N>
BrdfProjection<N> sum(const BrdfProjection<N>& a, const BrdfProjection<N>& b) {
  const auto relative_error = [&](auto kind) {
    const double scale = largest(a.*kind + b.*kind);
    return scale > 0.0 ? (a.error * largest(a.*kind) + b.error * largest(b.*kind)) / scale : 0.0;
  };
  using Projection = BrdfProjection<N>;
  return {a.with_cosine + b.with_cosine, a.without_cosine + b.without_cosine,
          (std::max)(relative_error(&Projection::with_cosine), relative_error(&Projection::without_cosine)),
          (std::max)(a.theta_nodes, b.theta_nodes)};
}

/// What a function becomes when phi changes its sign: itself, or its opposite.
enum class Parity { even, odd };

/// Adds to `moments` the integrals of f cos(m phi), m < N, over the full circle of wi at the angle theta from
/// the normal; of f sin(m phi) where f is odd.
template <int N, Parity parity, class F>
void add_azimuthal_moments(const F& brdf, const glm::dvec3& wo, double cos_theta, double sin_theta,
                           const QuadratureRule& rule, glm::dvec3 (&moments)[std::size_t(N)]) {
  for_each_azimuth(rule, [&](double cos_phi, double sin_phi, double weight) {
    const glm::dvec3 wi(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta);
    const glm::dvec3 weighted = brdf(wi, wo) * weight;
    double previous = parity == Parity::even ? cos_phi : -sin_phi;  // cos((m - 1) phi), or the sine
    double c = parity == Parity::even ? 1.0 : 0.0;                  // cos(m phi), or the sine
    for (int m = 0; m < N; ++m) {
      moments[m] += weighted * c;
      const double next = 2.0 * cos_phi * c - previous;
      previous = c;
      c = next;
    }
  });
}

/// Adds to both integrals a ring of directions at one theta, whose moments in phi are known. Y_l^m is its value at
/// phi = 0 times cos(m phi), and Y_l^-m the same times sin(m phi), so a ring needs the basis once.
template <int N>
void add_ring(const glm::dvec3 (&moments)[std::size_t(N)], double cos_theta, double sin_theta, double solid_angle,
              BrdfProjection<N>& result) {
  const EvenSh<N, double> basis = evaluate_even<N>(sin_theta, cos_theta);
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) {
      const glm::dvec3 term = moments[m] * (solid_angle * basis(l, m));
      result.with_cosine(l, m) += term * cos_theta;
      if (is_even_in_z(l, m)) result.without_cosine(l, m) += 2.0 * term;  // and its mirror image's
    }
  }
}

/// Where f is odd, (l, m) of the result is the coefficient of (l, -m).
template <int N, Parity parity = Parity::even, class F>
BrdfProjection<N> project_brdf_once(const F& brdf, double cos_outgoing, const QuadratureRule& rule) {
  const double theta_o = std::acos(cos_outgoing);
  const glm::dvec3 wo(std::sin(theta_o), 0.0, cos_outgoing);
  BrdfProjection<N> result;
  for_each_ring(theta_o, rule, [&](double cos_theta, double sin_theta, double weight) {
    glm::dvec3 moments[std::size_t(N)] = {};
    add_azimuthal_moments<N, parity>(brdf, wo, cos_theta, sin_theta, rule, moments);
    add_ring<N>(moments, cos_theta, sin_theta, weight, result);
  });
  result.theta_nodes = int(rule.nodes.size());
  return result;
}

/// The greatest movement of both kinds of coefficients.
struct ProjectionMovement {
  template <class Projection>
  double operator()(const Projection& coarse, const Projection& fine) const {
    return (std::max)(relative_movement(coarse.with_cosine, fine.with_cosine),
                      relative_movement(coarse.without_cosine, fine.without_cosine));
  }
};

/// at_level's projections refined, with the error that was reached.
template <class AtLevel>
auto refine_projection(int levels, double tolerance, const AtLevel& at_level) {
  auto [result, error] = refine(levels, tolerance, at_level, ProjectionMovement{});
  result.error = error;
  return result;
}

}  // namespace detail

/// Projects brdf, a callable (glm::dvec3 wi, glm::dvec3 wo) -> glm::dvec3 in 1/sr that is even in phi, seen
/// from cos_outgoing in [0, 1]. N bands; refined until no coefficient moves by more than tolerance times the
/// largest. The result's `error` says what was reached, also where the 512 nodes ran out first.
/// Its nodes are those of mirror_nodes.hpp; what the cosine and Y add, polynomials of degree N, is nothing to 64 of
/// them if N <= 32.
template <int N, class F>
BrdfProjection<N> project_brdf(const F& brdf, double cos_outgoing, double tolerance,
                               const ProjectionQuadrature& quadrature) {
  const auto at_level = [&](int level) {
    return detail::project_brdf_once<N>(brdf, cos_outgoing, quadrature.rule(level));
  };
  return detail::refine_projection(ProjectionQuadrature::levels, tolerance, at_level);
}

template <int N, class F>
BrdfProjection<N> project_brdf(const F& brdf, double cos_outgoing, double tolerance = 1e-4) {
  return project_brdf<N>(brdf, cos_outgoing, tolerance, ProjectionQuadrature());
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
