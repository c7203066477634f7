#include "bench.hpp"
int main(int argc, char** argv) {
  const zonal_bench::Effort effort;
  zonal_bench::register_evaluate(effort);
  zonal_bench::register_cap(effort);
  zonal_bench::register_orient(effort);
  zonal_bench::register_gather(effort);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
