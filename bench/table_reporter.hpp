// All tables as plain text, in place of Google Benchmark's listing.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>

namespace zonal_bench {

/// Collects all runs, and prints the tables after the last.
std::unique_ptr<benchmark::BenchmarkReporter> make_table_reporter();

}  // namespace zonal_bench
