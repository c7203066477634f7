#include "table_reporter.hpp"

#include <string>
#include <vector>

#include "machine.hpp"
#include "tables.hpp"

namespace zonal_bench {
namespace {

class TableReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      // Neither Google Benchmark's own medians, nor what has failed.
      if (run.run_type != Run::RT_Iteration || run.counters.count(time_counter) == 0) continue;
      const auto& name = run.run_name;
      Result& result = results_[name.args.empty() ? name.function_name : name.function_name + "/" + name.args];
      for (const auto& [key, counter] : run.counters) result.values[key] = counter.value;
      for (std::size_t i = 0; i < operation_counters.size(); ++i) {
        const auto count = result.values.find(operation_counters[i]);
        if (count != result.values.end()) result.counts[i] = static_cast<int>(count->second);
      }
      result.lanes = static_cast<int>(result.values.at(lanes_counter));
      result.seconds.push_back(result.values.at(time_counter));
    }
  }

  void Finalize() override {
    auto& out = GetOutputStream();
    const std::size_t count = runs(results_);
    out << compiler() << "\n"
        << processor() << ", " << (count > 1 ? format("medians of %zu runs", count) : "a single run") << "\n\n";
    print_hvl_figure_6(out, results_);
    out << "\n";
    print_gradient_table_1(out, results_);
    out << "\n";
    print_gradient_table_2(out, results_);
    out << "\n";
    print_gradient_figure_15(out);
    out << "\n";
    print_batches(out, results_);
    out << "\n";
    print_environments(out, results_);
    out << "\n";
    print_screen(out, results_);
    out << "\n";
    print_many_lights(out, results_);
    out << "\n";
    print_many_bands(out, results_);
    out << "\n";
    print_registry(out, results_);
    out.flush();
  }

 private:
  Results results_;
};

}  // namespace

std::unique_ptr<benchmark::BenchmarkReporter> make_table_reporter() { return std::make_unique<TableReporter>(); }

}  // namespace zonal_bench
