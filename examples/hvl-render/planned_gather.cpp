#include "planned_gather.hpp"

#include <algorithm>
#include <cmath>

#include "gather_hvl.hpp"
#include "shared/input_error.hpp"

namespace example::hvl_render {

template <zonal::Horizon H>
std::unique_ptr<PlannedGatherer> make_planned_hvl(const GatherInput& input, const ScenePlan& plan);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::none>(const GatherInput& input,
                                                                                        const ScenePlan& plan);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::smoothstep>(const GatherInput& input,
                                                                                              const ScenePlan& plan);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::exact>(const GatherInput& input,
                                                                                         const ScenePlan& plan);

namespace {

double root_of_ratio(double a, double b) { return b > 0.0 ? std::sqrt(a / b) : 0.0; }

std::unique_ptr<PlannedGatherer> make(const GatherInput& input, const ScenePlan& plan) {
  switch (input.options.horizon) {
    case HorizonRule::none: return make_planned_hvl<zonal::Horizon::none>(input, plan);
    case HorizonRule::smoothstep: return make_planned_hvl<zonal::Horizon::smoothstep>(input, plan);
    case HorizonRule::exact: return make_planned_hvl<zonal::Horizon::exact>(input, plan);
  }
  return nullptr;
}

}  // namespace

PlanFigures& PlanFigures::operator+=(const PlanFigures& other) {
  hits += other.hits, groups += other.groups, checked += other.checked;
  pairs += other.pairs, cut_lights += other.cut_lights, power += other.power, variance += other.variance;
  checked_power += other.checked_power, checked_error += other.checked_error;
  checked_seconds += other.checked_seconds;
  return *this;
}

double PlanFigures::proved_error() const { return root_of_ratio(variance, power); }
double PlanFigures::measured_error() const { return root_of_ratio(checked_error, checked_power); }
double PlanFigures::full_seconds() const {
  return checked > 0 ? checked_seconds / static_cast<double>(checked) * static_cast<double>(hits) : 0.0;
}

std::unique_ptr<PlannedGatherer> make_planned(const GatherInput& input, const ScenePlan& plan) {
  std::unique_ptr<PlannedGatherer> gatherer = make(input, plan);
  if (!gatherer) throw InputError("these numbers of bands are not compiled in");
  return gatherer;
}

}  // namespace example::hvl_render
