#include "scene_plan.hpp"

#include <algorithm>
#include <cstdint>

namespace example::hvl_render {
namespace {

using zonal::CoefficientPlan;
using zonal::Symmetry;

constexpr double of_nothing = 1e-5;

/// What serves both.
CoefficientPlan joined(CoefficientPlan a, const CoefficientPlan& b) {
  a.symmetry = std::max(a.symmetry, b.symmetry);  // from the most to the least
  a.bands = std::max(a.bands, b.bands);
  a.kept.resize(std::max(a.kept.size(), b.kept.size()), false);
  for (std::size_t i = 0; i < b.kept.size(); ++i) a.kept[i] = a.kept[i] || b.kept[i];
  a.error.mean = std::max(a.error.mean, b.error.mean);
  a.error.worst = std::max(a.error.worst, b.error.worst);
  return a;
}

CoefficientPlan everything(Symmetry symmetry, int bands) {
  CoefficientPlan plan{symmetry, bands, {}, {}};
  plan.kept.assign(static_cast<std::size_t>(bands * bands), true);
  return plan;
}

}  // namespace

ScenePlan plan_scene(const MaterialTables& tables, const Options& options) {
  const zonal::CoefficientRequest receiving{options.bands, of_nothing}, emitting{options.emission_bands, of_nothing};
  ScenePlan plan;
  for (std::uint32_t i = 0; i < tables.receiving.size(); ++i) {
    MaterialNeeds needs;
    if (tables.anisotropic[i]) {  // their rows are made when they are read
      needs = {everything(Symmetry::none, options.bands), everything(Symmetry::none, options.emission_bands)};
    } else {
      needs = {plan_receiver(tables.receiving[i], receiving), plan_emission(tables.emitting[i], emitting)};
      if (const auto parts = tables.parts.find(i); parts != tables.parts.end()) {
        needs.receiving = joined(needs.receiving, plan_receiver(*parts->second.receiving, receiving));
        needs.emitting = joined(needs.emitting, plan_emission(*parts->second.emitting, emitting));
      }
    }
    plan.emission_bands = std::max(plan.emission_bands, needs.emitting.bands);
    plan.materials.push_back(std::move(needs));
  }
  return plan;
}

}  // namespace example::hvl_render
