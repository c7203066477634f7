#include "stage_times.hpp"

#include <algorithm>

namespace example {

double StageTimes::seconds(const std::string& stage) const {
  const auto found =
      std::find_if(stages_.begin(), stages_.end(), [&](const auto& entry) { return entry.first == stage; });
  return found == stages_.end() ? 0.0 : found->second;
}

double StageTimes::total() const {
  double total = 0.0;
  for (const auto& [stage, seconds] : stages_) total += seconds;
  return total;
}

void StageTimes::add(const std::string& stage, double seconds) {
  const auto found =
      std::find_if(stages_.begin(), stages_.end(), [&](const auto& entry) { return entry.first == stage; });
  if (found == stages_.end()) {
    stages_.emplace_back(stage, seconds);
  } else {
    found->second += seconds;
  }
}

}  // namespace example
