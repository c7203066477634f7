// Anisotropic materials: their coefficients by both angles of the outgoing direction.
//
// As in projection.hpp, with two differences. The frame, z = normal and wo in the plane y = 0 with wo.x >= 0, is turned
// about the normal with wo: coefficients of nearby azimuths are then nearly equal, and those of an isotropic material
// equal. And f is not even in phi there: all N*N coefficients are kept.
//
// A whole table is 90 * 360 rows [1], 340 MB at 21 bands, and a row takes 4 to 16 ms (GGX of roughness 0.5 to 0.1),
// that of an anisotropic RGL file of 3 MB 40 ms within 3e-3 and 200 ms within 1e-4: rows are projected when they are
// first asked for.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022, section 4.2.
#pragma once

#include <cmath>
#include <utility>
#include <variant>

#include <glm/vec3.hpp>

#include "anisotropic_rows.hpp"
#include "brdf.hpp"
#include "node_projection.hpp"
#include "projection.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

inline glm::dvec3 turn_about_z(const glm::dvec3& v, double cosine, double sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

template <int N>
Sh<N, glm::dvec3> join(const EvenSh<N, glm::dvec3>& even, const EvenSh<N, glm::dvec3>& odd) {
  Sh<N, glm::dvec3> sh{};
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) {
      sh(l, -m) = odd(l, m);
      sh(l, m) = even(l, m);  // last: of the two at m = 0
    }
  }
  return sh;
}

template <int N, class F>
AnisotropicProjection<N> project_anisotropic_once(const F& brdf, double cos_outgoing, double azimuth,
                                                  const QuadratureRule& rule) {
  const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
  const auto part = [&](double sign) {
    return [&brdf, cosine, sine, sign](const glm::dvec3& wi, const glm::dvec3& wo) {
      const glm::dvec3 turned_wo = turn_about_z(wo, cosine, sine);
      return 0.5 * (brdf(turn_about_z(wi, cosine, sine), turned_wo) +
                    sign * brdf(turn_about_z({wi.x, -wi.y, wi.z}, cosine, sine), turned_wo));
    };
  };
  const auto even = project_brdf_once<N, Parity::even>(part(1.0), cos_outgoing, rule);
  const auto odd = project_brdf_once<N, Parity::odd>(part(-1.0), cos_outgoing, rule);
  return {join(even.with_cosine, odd.with_cosine), join(even.without_cosine, odd.without_cosine), 0.0};
}

}  // namespace detail

/// Projects brdf, a callable (glm::dvec3 wi, glm::dvec3 wo) -> glm::dvec3 in 1/sr, seen from cos_outgoing in [0, 1] and
/// the azimuth in radians. Refined as project_brdf is, and its error is the same measure.
template <int N, class F>
AnisotropicProjection<N> project_anisotropic_brdf(const F& brdf, double cos_outgoing, double azimuth, double tolerance,
                                                  const ProjectionQuadrature& quadrature) {
  const auto at_level = [&](int level) {
    return detail::project_anisotropic_once<N>(brdf, cos_outgoing, azimuth, quadrature.rule(level));
  };
  return detail::refine_projection(ProjectionQuadrature::levels, tolerance, at_level);
}

namespace detail {

/// The same by a quadrature of the BRDF's own: an anisotropic one's, or an isotropic one's, which knows of m >= 0
/// alone.
template <int N>
AnisotropicProjection<N> project_anisotropic_nodes(const MeasuredBrdf& brdf, double cos_outgoing, double azimuth,
                                                   double tolerance) {
  if (brdf.isotropic) {
    const BrdfProjection<N> even = project_nodes<N>(brdf.nodes, cos_outgoing, tolerance);
    return {join(even.with_cosine, {}), join(even.without_cosine, {}), even.error};
  }
  const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
  const glm::dvec3 wo =
      turn_about_z({std::sqrt((1.0 - cos_outgoing) * (1.0 + cos_outgoing)), 0.0, cos_outgoing}, cosine, sine);
  const auto at_level = [&](int level) {
    NodeSums<N, Parity::odd> sums;
    brdf.nodes(wo, level, [&](const glm::dvec3& wi, const glm::dvec3& weighted) {
      sums.add(turn_about_z(wi, cosine, -sine), weighted);
    });
    const auto even = sums.template project<Parity::even>();
    const auto odd = sums.template project<Parity::odd>();
    return AnisotropicProjection<N>{join(even.with_cosine, odd.with_cosine),
                                    join(even.without_cosine, odd.without_cosine), 0.0};
  };
  return refine_projection(brdf_node_levels, tolerance, at_level);
}

}  // namespace detail

inline AnisotropicTable::AnisotropicTable(BrdfFunction brdf, int bands, double tolerance, int azimuths)
    : AnisotropicTable(bands, azimuths) {
  project_ = [brdf = std::move(brdf), tolerance, quadrature = ProjectionQuadrature()](double cosine, double azimuth) {
    return project_anisotropic_brdf<max_bands>(brdf, cosine, azimuth, tolerance, quadrature);
  };
}

inline AnisotropicTable::AnisotropicTable(Brdf brdf, int bands, double tolerance, int azimuths)
    : AnisotropicTable(bands, azimuths) {
  Brdf rest, by_nodes;
  for (BrdfLobe& lobe : brdf.lobes) {
    const auto* measured = std::get_if<MeasuredBrdf>(&lobe);
    (measured != nullptr && measured->nodes ? by_nodes : rest).lobes.push_back(std::move(lobe));
  }
  project_ = [rest, by_nodes, tolerance, quadrature = ProjectionQuadrature()](double cosine, double azimuth) {
    AnisotropicProjection<max_bands> sum;
    if (!rest.lobes.empty()) {
      const auto f = [&rest](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(rest, wi, wo); };
      sum = project_anisotropic_brdf<max_bands>(f, cosine, azimuth, tolerance, quadrature);
    }
    for (const BrdfLobe& lobe : by_nodes.lobes) {
      const auto part =
          detail::project_anisotropic_nodes<max_bands>(std::get<MeasuredBrdf>(lobe), cosine, azimuth, tolerance);
      sum.with_cosine += part.with_cosine;
      sum.without_cosine += part.without_cosine;
    }
    return sum;
  };
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
