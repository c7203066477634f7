#include "results.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>

namespace zonal_bench {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

// Of what this processor has, the part that the compiler was told to use.
std::string instruction_set() {
  std::string set;
#if defined(__AVX512F__)
  set += ", AVX-512";
#elif defined(__AVX__)
  set += ", AVX";
#endif
#if defined(__FMA__)
  set += ", FMA";
#endif
  return set;
}

}  // namespace

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

std::string machine() { return ZONAL_BENCH_COMPILER + instruction_set() + "\n" + processor(); }

}  // namespace zonal_bench
