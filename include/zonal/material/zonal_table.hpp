// A material as one diffuse and one circularly symmetric lobe: N coefficients where N^2 would tell all.
//
// Seen from wo the glossy part of a BRDF is a lobe about the mirror direction r, here without the cosine of the
// incoming direction. Its mean over the circles about r is zonal: with z_l = integral of f(w, wo) Y_l^0(w . r) dw,
//
//   f(w, wo) ~ sum_l z_l Y_l^0(w . r)        and against a cap about w_j:   sum_l A_l z_l Y_l^0(w_j . r)
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022, section 6.3.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "../basis/evaluate.hpp"
#include "material_table.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The zonal coefficients of the lobe about its mirror direction. nodes(level, visit) gives visit(wi, f times solid
/// angle) those of a level; refined until no coefficient moves by more than tolerance times the largest.
template <int N, class Nodes>
Zh<N, glm::dvec3> project_mirror_lobe(int levels, const glm::dvec3& wo, double tolerance, const Nodes& nodes) {
  const glm::dvec3 mirror(-wo.x, 0.0, wo.z);
  const auto at_level = [&](int level) {
    Zh<N, glm::dvec3> sum{};
    nodes(level, [&](const glm::dvec3& wi, const glm::dvec3& weighted) {
      evaluate_zonal<N>(std::clamp(glm::dot(wi, mirror), -1.0, 1.0),
                        [&](auto l, double y) { sum.values[l] += weighted * y; });
    });
    return sum;
  };
  const auto movement = [](const auto& coarse, const auto& fine) { return relative_movement(coarse, fine); };
  return refine(levels, tolerance, at_level, movement).first;
}

/// Of a BRDF as a function, by the nodes that crowd at the mirror direction.
template <int N, class F>
Zh<N, glm::dvec3> project_mirror_lobe(const F& brdf, double cos_outgoing, double tolerance,
                                      const ProjectionQuadrature& quadrature) {
  const double theta_o = std::acos(cos_outgoing);
  const glm::dvec3 wo(std::sin(theta_o), 0.0, cos_outgoing);
  const auto nodes = [&](int level, const auto& visit) {
    for_each_mirror_node(theta_o, quadrature.rule(level),
                         [&](const glm::dvec3& wi, double solid_angle) { visit(wi, brdf(wi, wo) * solid_angle); });
  };
  return project_mirror_lobe<N>(ProjectionQuadrature::levels, wo, tolerance, nodes);
}

/// By a quadrature of the BRDF's own.
template <int N>
Zh<N, glm::dvec3> project_mirror_lobe(const BrdfNodes& own, double cos_outgoing, double tolerance) {
  const glm::dvec3 wo(std::sqrt((1.0 - cos_outgoing) * (1.0 + cos_outgoing)), 0.0, cos_outgoing);
  const auto nodes = [&](int level, const auto& visit) { own(wo, level, visit); };
  return project_mirror_lobe<N>(brdf_node_levels, wo, tolerance, nodes);
}

}  // namespace detail

/// The diffuse albedo of a material, by outgoing angle where another lobe takes of the light before, and the zonal
/// coefficients of its glossy part, RGB, without cosine, by outgoing angle: rows as those of MaterialTable, none for a
/// diffuse material.
class ZonalTable {
 public:
  static constexpr int max_bands = MaterialTable::max_bands;
  static constexpr int max_angles = MaterialTable::max_angles;

  /// `albedos`, 90 or none, are added to the diffuse albedo, by outgoing angle.
  ZonalTable(const glm::vec3& diffuse_albedo, int bands, std::vector<glm::vec3> rows,
             std::vector<glm::vec3> albedos = {})
      : diffuse_albedo_(diffuse_albedo),
        bands_(std::clamp(bands, 1, max_bands)),
        rows_(std::move(rows)),
        albedos_(std::move(albedos)) {
    assert(bands_ == bands);
    assert(rows_.empty() || rows_.size() == std::size_t(max_angles * bands));
    if (!rows_.empty()) rows_.resize(std::size_t(max_angles * bands_), glm::vec3(0.0F));  // what is missing is zero
    if (!albedos_.empty()) albedos_.resize(std::size_t(max_angles), glm::vec3(0.0F));
  }

  /// At the outgoing direction whose z is cos_outgoing.
  glm::vec3 diffuse_albedo(float cos_outgoing) const {
    Zh<1, glm::vec3> angular{};
    if (!albedos_.empty()) detail::interpolate_rows(albedos_, max_angles, cos_outgoing, angular);
    return diffuse_albedo_ + angular[0];
  }
  int bands() const { return bands_; }
  bool is_diffuse() const { return rows_.empty(); }

  /// The glossy lobe about the mirror direction at the outgoing direction whose z is cos_outgoing. Bands that the table
  /// does not have are zero.
  template <int N>
  Zh<N, glm::vec3> glossy(float cos_outgoing) const {
    Zh<N, glm::vec3> result{};
    if (!is_diffuse()) detail::interpolate_rows(rows_, max_angles, cos_outgoing, result);
    return result;
  }

 private:
  glm::vec3 diffuse_albedo_;
  int bands_;
  std::vector<glm::vec3> rows_, albedos_;
};

/// The zonal table of a material: the lobes of is_diffuse are the diffuse part, all else the glossy one. See
/// project_material for the tolerance.
template <class ForEach = SerialForEach>
ZonalTable project_zonal(const Brdf& brdf, int bands, double tolerance = 1e-4, ForEach&& for_each = {}) {
  constexpr int all_bands = ZonalTable::max_bands;
  const glm::vec3 diffuse = diffuse_albedo(brdf);
  Brdf glossy, by_nodes, bodies;
  for (const BrdfLobe& lobe : glossy_part(brdf).lobes) {
    (is_diffuse(lobe) ? bodies : detail::has_own_nodes(lobe) ? by_nodes : glossy).lobes.push_back(lobe);
  }
  std::vector<glm::vec3> albedos;
  for (int angle = 0; !bodies.lobes.empty() && angle < ZonalTable::max_angles; ++angle) {
    albedos.push_back(diffuse_albedo(bodies, float(std::cos(double(kPi) / 180.0 * angle))));
  }
  if (glossy.lobes.empty() && by_nodes.lobes.empty()) return {diffuse, bands, {}, std::move(albedos)};

  bands = std::clamp(bands, 1, ZonalTable::max_bands);
  std::vector<glm::vec3> rows(std::size_t(ZonalTable::max_angles * bands));
  const auto function = [&glossy](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(glossy, wi, wo); };
  const ProjectionQuadrature quadrature;
  for_each(ZonalTable::max_angles, [&](int angle) {
    const double cos_outgoing = std::cos(double(kPi) / 180.0 * angle);
    Zh<all_bands, glm::dvec3> sum{};
    if (!glossy.lobes.empty()) {
      sum += detail::project_mirror_lobe<all_bands>(function, cos_outgoing, tolerance, quadrature);
    }
    for (const BrdfLobe& lobe : by_nodes.lobes) {
      sum += detail::project_mirror_lobe<all_bands>(std::get<MeasuredBrdf>(lobe).nodes, cos_outgoing, tolerance);
    }
    for (int l = 0; l < bands; ++l) rows[std::size_t(angle * bands + l)] = glm::vec3(sum[l]);
  });
  return {diffuse, bands, std::move(rows), std::move(albedos)};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
