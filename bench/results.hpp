// What was measured, collected for the tables.
#pragma once

#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "bench.hpp"

namespace zonal_bench {

/// What was measured under one name.
struct Result {
  std::array<int, operation_counters.size()> counts{};
  int lanes = 1;
  std::vector<double> seconds;           // per item, one for each run
  std::map<std::string, double> values;  // what else the benchmark says

  int operations() const;
  double median_ns() const;
};

/// By the benchmark's name, with its argument; what a filter has left out is not there.
using Results = std::map<std::string, Result>;

/// Null where it is not there.
const Result* find(const Results& results, const std::string& name);

/// How many runs the medians are of.
std::size_t runs(const Results& results);

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

}  // namespace zonal_bench
