#include "table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "bench.hpp"

namespace zonal_bench {
namespace {

// What was measured under one name.
struct Result {
  std::array<int, operation_counters.size()> counts{};
  int lanes = 1;
  std::vector<double> seconds;  // per item, one for each run

  int operations() const {
    int sum = 0;
    for (int count : counts) sum += count;
    return sum;
  }
  double median_ns() const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return 1e9 * (sorted[sorted.size() / 2] + sorted[(sorted.size() - 1) / 2]) / 2;
  }
};

// By the benchmark's name, with its argument; what a filter has left out is not there.
using Results = std::map<std::string, Result>;

const Result* find(const Results& results, const std::string& name) {
  const auto entry = results.find(name);
  return entry == results.end() ? nullptr : &entry->second;
}

constexpr int last_bands = 10;
constexpr int example_bands = 5;  // at which the kinds of operations are listed

struct Column {
  const char *title, *kernel, *argument;
};
constexpr std::array columns{Column{"evaluate", "evaluate", ""},
                             Column{"polynomial", "polynomial", ""},
                             Column{"orient", "orient", ""},
                             Column{"cap stable", "cap-stable", ""},
                             Column{"cap Eq. 14", "cap-legendre", ""},
                             Column{"cap closed", "cap-closed", ""},
                             Column{"light", "gather-smoothstep-3", "/400"}};

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

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

void print_heading(std::ostream& out, const Results& results) {
  std::size_t runs = 0;
  for (const auto& [name, result] : results) runs = std::max(runs, result.seconds.size());
  out << "HVL Fig. 6: operations, counted by the recorder, and ns per direction, cap or light\n"
      << ZONAL_BENCH_COMPILER << instruction_set() << "\n"
      << processor() << ", one thread, " << (runs > 1 ? format("median of %zu runs", runs) : "a single run") << "\n";
}

void print_scalar(std::ostream& out, const Results& results, const std::string& scalar) {
  const auto result = [&](const Column& column, int bands) {
    return find(results, kernel_name(column.kernel, bands) + "/" + scalar + column.argument);
  };
  // Not every scalar gathers.
  const auto is_empty = [&](const Column& column) {
    for (int bands = 1; bands <= last_bands; ++bands) {
      if (result(column, bands) != nullptr) return false;
    }
    return true;
  };
  std::vector<Column> shown(columns.begin(), columns.end());
  shown.erase(std::remove_if(shown.begin(), shown.end(), is_empty), shown.end());
  if (shown.empty()) return;

  const Result* any = nullptr;
  for (int bands = 1; any == nullptr; ++bands) any = result(shown.front(), bands);
  out << "\n" << scalar << format(", lanes: %d\n     ", any->lanes);
  for (const Column& column : shown) out << format("%14s", column.title);
  out << "\nbands";
  for (std::size_t i = 0; i < shown.size(); ++i) out << format("%7s%7s", "ops", "ns");
  for (int bands = 1; bands <= last_bands; ++bands) {
    out << format("\n%5d", bands);
    for (const Column& column : shown) {
      const Result* r = result(column, bands);
      out << (r ? format("%7d%7.2f", r->operations(), r->median_ns()) : format("%7s%7s", "-", "-"));
    }
  }
  out << "\n";
}

void print_kinds(std::ostream& out, const Results& results) {
  const auto print = [&](const std::string& kernel, const Result& result) {
    out << format("%-24s", kernel.c_str());
    for (int count : result.counts) out << format("%6d", count);
    out << format("%7d", result.operations());
  };
  out << "\n" << format("%-24s", "kernel/bands");
  for (const char* kind : operation_counters) out << format("%6s", kind);
  out << "    ops";
  for (int lights : gather_lights) out << format("%7d", lights);
  out << " lights, ns per light\n";
  for (const Column& column : columns) {
    const std::string kernel = kernel_name(column.kernel, example_bands);
    if (const Result* r = find(results, kernel + "/float")) {
      print(kernel, *r);
      out << "\n";
    }
  }
  // gather-horizon-emission bands/bands
  const std::string ending = "/packet/" + std::to_string(gather_lights.front());
  for (const auto& [name, result] : results) {
    const std::size_t end = name.find(ending);
    if (end == std::string::npos || end + ending.size() != name.size()) continue;
    const std::string kernel = name.substr(0, end);
    print(kernel, result);
    for (int lights : gather_lights) {
      const Result* r = find(results, kernel + "/packet/" + std::to_string(lights));
      out << (r ? format("%7.2f", r->median_ns()) : format("%7s", "-"));
    }
    out << "\n";
  }
}

// What the paper's text says of its figure, which it prints as a curve, without numbers.
void print_crossover(std::ostream& out, const Results& results) {
  int bands = last_bands;
  for (; bands > 0; --bands) {
    const Result* closed_form = find(results, kernel_name("cap-closed", bands) + "/float");
    const Result* legendre = find(results, kernel_name("cap-legendre", bands) + "/float");
    if (closed_form == nullptr || legendre == nullptr) return;
    if (closed_form->operations() <= legendre->operations()) break;
  }
  out << "\nHVL 4.2: \"beyond 5 SH bands\" the closed forms take more operations than Eq. 14,\n"
         "z_l = sqrt(pi / (2l+1)) (P_(l-1) - P_(l+1)). Here: beyond "
      << bands << " bands.\n";
}

class TableReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      // Neither Google Benchmark's own medians, nor what has failed.
      if (run.run_type != Run::RT_Iteration || run.counters.count(time_counter) == 0) continue;
      const auto& name = run.run_name;
      Result& result = results_[name.args.empty() ? name.function_name : name.function_name + "/" + name.args];
      const auto counter = [&](const char* key) { return run.counters.at(key).value; };
      for (std::size_t i = 0; i < operation_counters.size(); ++i) {
        result.counts[i] = static_cast<int>(counter(operation_counters[i]));
      }
      result.lanes = static_cast<int>(counter(lanes_counter));
      result.seconds.push_back(counter(time_counter));
    }
  }

  void Finalize() override {
    auto& out = GetOutputStream();
    print_heading(out, results_);
    for (const char* scalar : {"float", "double", "packet"}) print_scalar(out, results_, scalar);
    print_kinds(out, results_);
    print_crossover(out, results_);
    out.flush();
  }

 private:
  Results results_;
};

}  // namespace

std::unique_ptr<benchmark::BenchmarkReporter> make_table_reporter() { return std::make_unique<TableReporter>(); }

}  // namespace zonal_bench
