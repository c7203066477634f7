// Nodes of a quadrature over the hemisphere that crowd at the mirror direction, and its refinement.
//
// A glossy lobe is a peak at the mirror direction, theta = theta_o and phi = pi. A uniform grid needs nodes in inverse
// proportion to the peak's width, and a coarse one can step over it twice and look converged. So the intervals are made
// to end at the peak: theta is split at theta_o, and phi runs over the half circle from pi to 0. Gauss-Legendre nodes
// crowd towards the end of an interval, n of them to 1.4 / n^2 of its length; with the substitution
// theta = theta_o +- length s^2, phi = pi - pi s^2, to 2 / n^4. The number of nodes then grows with the fourth root of
// the sharpness, and the first rule already has nodes within 1e-5 of the peak. Inside the intervals the integrand is
// smooth: convergence is geometric, and the error of the finer of two rules is far below their difference.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/vec3.hpp>

#include "../scalar/quadrature.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The Gauss-Legendre rules of 32, 64, ..., 512 nodes that project_brdf refines through. Build it once (a few
/// milliseconds) and share it, also between threads, when projecting many directions.
class ProjectionQuadrature {
 public:
  static constexpr int first_size = 32;
  static constexpr int levels = 5;

  ProjectionQuadrature() {
    for (int level = 0; level < levels; ++level) rules_[level] = gauss_legendre(first_size << level);
  }
  const QuadratureRule& rule(int level) const { return rules_[level]; }

 private:
  QuadratureRule rules_[levels];
};

/// visit(place, weight): nodes of [0, 1] that crowd at 0, place = s^2.
template <class Visit>
void for_each_crowded_node(const QuadratureRule& rule, const Visit& visit) {
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double s = 0.5 * (1.0 + rule.nodes[i]);
    visit(s * s, s * rule.weights[i]);  // 2 s ds, ds = half the rule's
  }
}

/// visit(cos theta, sin theta, weight): rings of directions about the normal that crowd at theta_o, 0 to pi/2. The
/// weight times dphi is a solid angle.
template <class Visit>
void for_each_ring(double theta_o, const QuadratureRule& rule, const Visit& visit) {
  for (const double end : {0.0, 0.5 * double(kPi)}) {
    const double width = end - theta_o;
    if (detail::is_equal(width, 0.0)) continue;
    for_each_crowded_node(rule, [&](double place, double weight) {
      const double theta = theta_o + width * place, sin_theta = std::sin(theta);
      visit(std::cos(theta), sin_theta, std::abs(width) * weight * sin_theta);
    });
  }
}

/// visit(cos phi, sin phi, weight): azimuths that crowd at pi, of the half circle of sin phi >= 0. It counts twice: the
/// weights' sum is 2 pi.
template <class Visit>
void for_each_azimuth(const QuadratureRule& rule, const Visit& visit) {
  for_each_crowded_node(rule, [&](double place, double weight) {
    const double from_mirror = double(kPi) * place;
    visit(-std::cos(from_mirror), std::sin(from_mirror), 2.0 * double(kPi) * weight);
  });
}

/// visit(wi, solid angle): all nodes, rings by azimuths.
template <class Visit>
void for_each_mirror_node(double theta_o, const QuadratureRule& rule, const Visit& visit) {
  for_each_ring(theta_o, rule, [&](double cos_theta, double sin_theta, double ring) {
    for_each_azimuth(rule, [&](double cos_phi, double sin_phi, double weight) {
      visit(glm::dvec3(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta), ring * weight);
    });
  });
}

namespace detail {

/// at_level(0), at_level(1), ..., until the movement(coarse, fine) between two is within the tolerance, or no level is
/// left. Returns the finer of the two, and the movement.
template <class AtLevel, class Movement>
auto refine(int levels, double tolerance, const AtLevel& at_level, const Movement& movement) {
  auto coarse = at_level(0);
  for (int level = 1;; ++level) {
    auto fine = at_level(level);
    const double error = movement(coarse, fine);
    if (error <= tolerance || level + 1 == levels) return std::pair(std::move(fine), error);
    coarse = std::move(fine);
  }
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
