// Projects a material for all of its outgoing directions. The table it goes to: material_rows.hpp.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "../scalar/for_each.hpp"
#include "brdf.hpp"
#include "material_rows.hpp"
#include "node_projection.hpp"
#include "projection.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// project(cosine of the outgoing angle) -> BrdfProjection, for all of the table's angles.
template <class Project, class ForEach>
std::vector<BrdfProjection<MaterialTable::max_bands>> project_all_angles(const Project& project, ForEach&& for_each) {
  std::vector<BrdfProjection<MaterialTable::max_bands>> projections(MaterialTable::max_angles);
  for_each(MaterialTable::max_angles,
           [&](int angle) { projections[std::size_t(angle)] = project(std::cos(double(kPi) / 180.0 * angle)); });
  return projections;
}

/// Is it a measured material with a quadrature of its own?
inline bool has_own_nodes(const BrdfLobe& lobe) {
  const auto* measured = std::get_if<MeasuredBrdf>(&lobe);
  return measured != nullptr && measured->nodes;
}

template <class F>
inline constexpr bool is_brdf_function = std::is_invocable_r_v<glm::dvec3, F, glm::dvec3, glm::dvec3>;

}  // namespace detail

/// Projects an isotropic material given as a function (glm::dvec3 wi, glm::dvec3 wo) -> glm::dvec3 in 1/sr,
/// say a measured one. See project_brdf for the tolerance.
///
/// All 21 bands are projected, whatever `bands` asks for: the sharpness of the lobe, not the bands,
/// determines the nodes, the rest is cheap, and tables of different sizes then agree to the last bit.
template <class F, class ForEach = SerialForEach, std::enable_if_t<detail::is_brdf_function<F>, int> = 0>
MaterialTable project_material(const F& brdf, int bands, double tolerance = 1e-4, ForEach&& for_each = {}) {
  const ProjectionQuadrature quadrature;
  const auto project = [&](double cos_outgoing) {
    return project_brdf<MaterialTable::max_bands>(brdf, cos_outgoing, tolerance, quadrature);
  };
  return MaterialTable(detail::project_all_angles(project, for_each), bands);
}

/// The same for a sum of lobes. What does not depend on the outgoing direction is projected once; a material that has
/// nothing else needs a single row. 90 rows of GGX take 0.2 to 0.4 s on one core. A measured lobe that has a quadrature
/// of its own is projected by it.
template <class ForEach = SerialForEach>
MaterialTable project_material(const Brdf& brdf, int bands, double tolerance = 1e-4, ForEach&& for_each = {}) {
  constexpr int all_bands = MaterialTable::max_bands;
  Brdf diffuse, glossy, by_nodes;
  for (const BrdfLobe& lobe : brdf.lobes) {
    const bool is_diffuse = std::holds_alternative<LambertBrdf>(lobe);
    (is_diffuse ? diffuse : detail::has_own_nodes(lobe) ? by_nodes : glossy).lobes.push_back(lobe);
  }
  const auto function = [](const Brdf& part) {
    return [&part](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(part, wi, wo); };
  };
  const auto base = project_brdf<all_bands>(function(diffuse), 1.0, tolerance);
  if (glossy.lobes.empty() && by_nodes.lobes.empty()) return MaterialTable({base}, bands);

  const ProjectionQuadrature quadrature;
  const auto project = [&](double cos_outgoing) {
    BrdfProjection<all_bands> sum = base;
    if (!glossy.lobes.empty()) {
      sum = detail::sum(project_brdf<all_bands>(function(glossy), cos_outgoing, tolerance, quadrature), sum);
    }
    for (const BrdfLobe& lobe : by_nodes.lobes) {
      const BrdfNodes& nodes = std::get<MeasuredBrdf>(lobe).nodes;
      sum = detail::sum(detail::project_nodes<all_bands>(nodes, cos_outgoing, tolerance), sum);
    }
    return sum;
  };
  return MaterialTable(detail::project_all_angles(project, for_each), bands);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
