// zonal-bench                  Google Benchmark, with all its flags
// zonal-bench --table          the papers' tables
// zonal-bench --table=quick    the same tables, of times that mean nothing

#include <cstdio>
#include <exception>
#include <string_view>
#include <vector>

#include <zonal/file/standard_output.hpp>

#include "bench.hpp"
#include "table_reporter.hpp"

namespace zonal_bench {
namespace {

int run(int argc, char** argv) {
  // Interleaved, or another process would disturb all runs of a benchmark alike. Flags that follow win.
  char interleave[] = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments{argv[0]};
  bool is_table = false;
  Effort effort;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--table" || argument == "--table=quick") {
      is_table = true;
      effort = argument == "--table" ? Effort{0.02, 7} : Effort{1e-9, 1};
      arguments.insert(arguments.begin() + 1, interleave);
    } else {
      arguments.push_back(argv[i]);
    }
  }
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);

  register_evaluate(effort);
  register_cap(effort);
  register_orient(effort);
  register_gather(effort);
  register_gradient(effort);
  register_grid(effort);
  register_batch(effort);
  register_adjoint(effort);
  register_environment(effort);
  register_screen(effort);
  register_many_lights(effort);
  register_many_bands(effort);
  register_registry(effort);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  if (is_table) {
    const auto reporter = make_table_reporter();
    benchmark::RunSpecifiedBenchmarks(reporter.get());
  } else {
    benchmark::RunSpecifiedBenchmarks();
  }
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace zonal_bench

int main(int argc, char** argv) {
  try {
    return zonal::with_standard_output([&] { return zonal_bench::run(argc, argv); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-bench: %s\n", error.what());
    return 1;
  }
}
