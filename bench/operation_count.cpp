#include "operation_count.hpp"

#include <array>
#include <map>
#include <string>
#include <utility>

#include <zonal/scalar/recorder.hpp>

#include "gather_kernels.hpp"
#include "kernels.hpp"

namespace zonal_bench {
namespace {

using Counts = std::map<std::pair<std::string, int>, zonal::OperationCount>;

Counts count_all() {
  Counts counts;
  const auto count = [&](auto kernel) {
    using Kernel = decltype(kernel);
    zonal::Recording recording;
    std::array<zonal::Recorder, Kernel::Domain::inputs> inputs;
    for (auto& input : inputs) input = recording.input("input");
    const auto result = Kernel::run(inputs);
    counts[{Kernel::name, Kernel::bands}] = recording.count(result.begin(), result.end());
  };
  for_evaluate_kernels(count);
  for_cap_kernels(count);
  for_orient_kernels(count);
  for_gather_kernels(count);
  for_gradient_kernels(count);
  return counts;
}

}  // namespace

zonal::OperationCount operation_count(const char* name, int bands) {
  static const Counts counts = count_all();
  return counts.at({name, bands});
}

}  // namespace zonal_bench
