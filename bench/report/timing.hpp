// Times as medians of interleaved repetitions: another process would disturb all runs of one body alike. It is the
// processor's time that counts, of this one thread, not what others take in between.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <vector>

#include "report.hpp"

namespace zonal_report {

using Body = std::function<void()>;

/// How often, and how long at least one repetition takes.
struct Repetitions {
  int count;
  double seconds;
};
inline Repetitions repetitions(Effort effort) { return choose<Repetitions>(effort, {1, 1e-4}, {7, 0.002}, {11, 0.01}); }

inline double seconds_of(const Body& body, int calls) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < calls; ++i) body();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Seconds of one call of each body.
inline std::vector<double> median_seconds(const std::vector<Body>& bodies, const Repetitions& repetitions) {
  std::vector<int> calls;
  for (const Body& body : bodies) {
    int count = 1;
    while (seconds_of(body, count) < repetitions.seconds) count *= 2;  // and the caches are warm
    calls.push_back(count);
  }
  std::vector<std::vector<double>> seconds(bodies.size());
  for (int repetition = 0; repetition < repetitions.count; ++repetition) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      seconds[i].push_back(seconds_of(bodies[i], calls[i]) / calls[i]);
    }
  }
  std::vector<double> medians;
  for (const auto& values : seconds) medians.push_back(median(values));
  return medians;
}

}  // namespace zonal_report
