// HVL Fig. 6 as a plain table, in place of Google Benchmark's listing.
#pragma once

#include <benchmark/benchmark.h>

#include <memory>

namespace zonal_bench {

/// Collects all runs, and prints their medians after the last.
std::unique_ptr<benchmark::BenchmarkReporter> make_table_reporter();

}  // namespace zonal_bench
