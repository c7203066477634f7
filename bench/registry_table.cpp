// Every kernel of the registry: operations, times, and how near to the limit that binds they are.
#include <ostream>
#include <string>

#include "limits.hpp"
#include "tables.hpp"

namespace zonal_bench {
namespace {

Work work_of(const Result& result) {
  const auto& [additions, multiplications, divisions, functions, comparisons] = result.counts;
  const auto value = [&](const char* name) { return result.values.at(name); };
  const int fused = static_cast<int>(value(fused_counter));
  return {{additions, multiplications, divisions, functions, comparisons, fused},
          value(loads_counter),
          value(stores_counter)};
}

}  // namespace

void print_registry(std::ostream& out, const Results& results) {
  const Limits limits =
      measure_limits(runs(results) > 1 ? zonal_report::Repetitions{7, 0.002} : zonal_report::Repetitions{1, 1e-4});
  out << "Every kernel of the registry, those with bands at 5: operations, counted by the recorder, and ns, one\n"
         "thread; for packets the limit that binds and how much of the time it takes (bench/limits.hpp)\n\n"
      << format("%-42s%6s%6s%6s%6s%6s%6s", "kernel/bands", "add", "mul", "fused", "div", "fun", "cmp")
      << format("%10s%10s  %-10s%7s\n", "float", "packet", "limit", "share");
  for (const std::string& name : registry_names()) {
    const Result* one = find(results, name + "/float");
    const Result* packet = find(results, name + "/packet");
    if (one == nullptr) continue;
    const Work work = work_of(*one);
    const auto& count = work.count;
    out << format("%-42s%6d%6d%6d%6d%6d%6d%10.2f", name.c_str(), count.additions, count.multiplications, count.fused,
                  count.divisions, count.functions, count.comparisons, one->median_ns());
    if (packet != nullptr) {
      const Bound bound = find_bound(limits, work);
      out << format("%10.2f", packet->median_ns());
      if (count.total() > 0) {  // or the compiler may write once what each run writes
        out << format("  %-10s%6.0f%%", bound.name, 100 * bound.ns / (packet->median_ns() * packet->lanes));
      }
    }
    out << "\n";
  }
}

}  // namespace zonal_bench
