#include "planned_gather.hpp"

#include <cmath>

#include <zonal/gather/horizon.hpp>

#include "shared/input_error.hpp"

namespace example::hvl_render {

template <zonal::Horizon H>
std::unique_ptr<PlannedGatherer> make_planned_hvl(const GatherInput& input);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::none>(const GatherInput& input);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::smoothstep>(const GatherInput& input);
extern template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::exact>(const GatherInput& input);

namespace {

double root_of_ratio(double a, double b) { return b > 0.0 ? std::sqrt(a / b) : 0.0; }

std::unique_ptr<PlannedGatherer> make(const GatherInput& input) {
  switch (input.options.horizon) {
    case HorizonRule::none: return make_planned_hvl<zonal::Horizon::none>(input);
    case HorizonRule::smoothstep: return make_planned_hvl<zonal::Horizon::smoothstep>(input);
    case HorizonRule::exact: return make_planned_hvl<zonal::Horizon::exact>(input);
  }
  return nullptr;
}

}  // namespace

PlanFigures& PlanFigures::operator+=(const PlanFigures& other) {
  hits += other.hits, groups += other.groups, checked += other.checked;
  pairs += other.pairs, draws += other.draws, power += other.power, variance += other.variance;
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
