#include "planned_gather.hpp"

#include <algorithm>
#include <cmath>

#include <zonal/gather/horizon.hpp>

#include "shared/input_error.hpp"

namespace example::hvl_render {

template <zonal::Horizon H>
std::unique_ptr<PlannedGatherer> make_planned_hvl(const GatherInput& input, const SceneNeeds& needs);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::none>(const GatherInput& input,
                                                                                        const SceneNeeds& needs);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::smoothstep>(const GatherInput& input,
                                                                                              const SceneNeeds& needs);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::exact>(const GatherInput& input,
                                                                                         const SceneNeeds& needs);

namespace {

double root_of_ratio(double a, double b) { return b > 0.0 ? std::sqrt(a / b) : 0.0; }

/// Is nothing but rounding left of a table's coefficients beyond what `is_kept(l, m)` says?
template <class IsKept>
bool is_enough(const std::vector<glm::vec3>& rows, int bands, const IsKept& is_kept) {
  float greatest = 0.0f, left = 0.0f;
  for (std::size_t i = 0; i < rows.size();) {
    for (int l = 0; l < bands; ++l) {
      for (int m = 0; m <= l; ++m, ++i) {
        const float value = glm::length(rows[i]);
        greatest = std::max(greatest, value);
        if (!is_kept(l, m)) left = std::max(left, value);
      }
    }
  }
  return left <= 1e-6f * greatest;
}

SceneNeeds needs_of(const MaterialTables& tables, const Options& options) {
  SceneNeeds needs;
  for (std::size_t i = 0; i < tables.receiving.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto parts = tables.parts.find(number);
    const auto is_zonal = [](const zonal::MaterialTable& table) {
      return is_enough(table.with_cosine_rows(), table.bands(), [](int, int m) { return m == 0; });
    };
    const auto is_even = [](const zonal::MaterialTable& table) {
      return is_enough(table.without_cosine_rows(), table.bands(), [](int l, int) { return l == 0; });
    };
    const bool has_parts = parts != tables.parts.end();
    const bool anisotropic = tables.anisotropic[i] != nullptr;
    const bool same_about =
        !anisotropic && is_zonal(tables.receiving[i]) && (!has_parts || is_zonal(*parts->second.receiving));
    const bool even = !anisotropic && is_even(tables.emitting[i]) && (!has_parts || is_even(*parts->second.emitting));
    needs.symmetry.push_back(anisotropic  ? zonal::Symmetry::none
                             : same_about ? zonal::Symmetry::zonal
                                          : zonal::Symmetry::mirror);
    if (!even) needs.emission_bands = options.emission_bands;
  }
  return needs;
}

std::unique_ptr<PlannedGatherer> make(const GatherInput& input) {
  const SceneNeeds needs = needs_of(input.materials, input.options);
  switch (input.options.horizon) {
    case HorizonRule::none: return make_planned_hvl<zonal::Horizon::none>(input, needs);
    case HorizonRule::smoothstep: return make_planned_hvl<zonal::Horizon::smoothstep>(input, needs);
    case HorizonRule::exact: return make_planned_hvl<zonal::Horizon::exact>(input, needs);
  }
  return nullptr;
}

}  // namespace

PlanFigures& PlanFigures::operator+=(const PlanFigures& other) {
  hits += other.hits, groups += other.groups, checked += other.checked;
  pairs += other.pairs, magnitude += other.magnitude, power += other.power, variance += other.variance;
  checked_power += other.checked_power, checked_error += other.checked_error;
  checked_variance += other.checked_variance;
  return *this;
}

double PlanFigures::proved_error() const { return root_of_ratio(variance, power); }
double PlanFigures::measured_error() const { return root_of_ratio(checked_error, checked_power); }

std::unique_ptr<PlannedGatherer> make_planned(const GatherInput& input) {
  std::unique_ptr<PlannedGatherer> gatherer = make(input);
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

}  // namespace example::hvl_render
