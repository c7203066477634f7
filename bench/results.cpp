#include "results.hpp"

#include <algorithm>
#include <numeric>

namespace zonal_bench {

int Result::operations() const { return std::accumulate(counts.begin(), counts.end(), 0); }

double Result::median_ns() const {
  std::vector<double> sorted = seconds;
  std::sort(sorted.begin(), sorted.end());
  return 1e9 * (sorted[sorted.size() / 2] + sorted[(sorted.size() - 1) / 2]) / 2;
}

const Result* find(const Results& results, const std::string& name) {
  const auto entry = results.find(name);
  return entry == results.end() ? nullptr : &entry->second;
}

std::size_t runs(const Results& results) {
  std::size_t most = 0;
  for (const auto& [name, result] : results) most = std::max(most, result.seconds.size());
  return most;
}

}  // namespace zonal_bench
