#include "scene_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

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

/// What virtual lights read of it.
zonal::MaterialTable first_bands(const zonal::MaterialTable& table, int bands) {
  const int size = zonal::even_index(std::min(bands, table.bands()), 0);
  std::vector<glm::vec3> rows[2];
  const std::vector<glm::vec3>* const whole[] = {&table.with_cosine_rows(), &table.without_cosine_rows()};
  for (int k = 0; k < 2; ++k) {
    for (int row = 0; row < table.angles(); ++row) {
      const auto first = whole[k]->begin() + row * table.row_size();
      rows[k].insert(rows[k].end(), first, first + size);
    }
  }
  return {std::min(bands, table.bands()), table.angles(), table.achieved_error(), std::move(rows[0]),
          zonal::MirroredRows(std::move(rows[1]))};
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
      const zonal::MaterialTable& table = tables.receiving[i].whole();
      needs = {plan_receiver(table, receiving), plan_emission(tables.emitting[i], emitting)};
      const auto parts = tables.parts.find(i);
      if (parts != tables.parts.end()) {
        const zonal::MaterialTable& body = parts->second.receiving->whole();
        needs.receiving = joined(needs.receiving, plan_receiver(body, receiving));
        needs.emitting = joined(needs.emitting, plan_emission(*parts->second.emitting, emitting));
        plan.half_error = std::max(plan.half_error, half_error(body, needs.receiving).mean);
      }
      plan.half_error = std::max(plan.half_error, half_error(table, needs.receiving).mean);
    }
    plan.emission_bands = std::max(plan.emission_bands, needs.emitting.bands);
    plan.materials.push_back(std::move(needs));
  }
  if (plan.half_error <= 0.05 * options.tolerance) {
    plan.coefficient_bits = 16;
  } else {
    plan.half_error = 0;
  }
  return plan;
}

TableBytes keep_planned(MaterialTables& tables, const ScenePlan& plan) {
  TableBytes bytes{0, tables.bytes()};
  for (std::uint32_t i = 0; i < plan.materials.size(); ++i) {
    const MaterialNeeds& needs = plan.materials[i];
    const auto keep = [&](ReceivingTable& receiving, zonal::MaterialTable& emitting) {
      receiving.keep(needs.receiving, plan.coefficient_bits);
      emitting = first_bands(emitting, needs.emitting.bands);
    };
    keep(tables.receiving[i], tables.emitting[i]);
    if (const auto parts = tables.parts.find(i); parts != tables.parts.end()) {
      keep(*parts->second.receiving, *parts->second.emitting);
    }
  }
  bytes.planned = tables.bytes();
  return bytes;
}

}  // namespace example::hvl_render
