#include "kernel_facts.hpp"

#include <map>
#include <string>
#include <utility>

#include "gather_kernels.hpp"
#include "kernels.hpp"
#include "registry_kernels.hpp"

namespace zonal_bench {
namespace {

using Facts = std::map<std::pair<std::string, int>, KernelFacts>;

Facts all_facts() {
  Facts facts;
  const auto add = [&](auto kernel) {
    using Kernel = decltype(kernel);
    facts[{Kernel::name, Kernel::bands}] = facts_of<typename Kernel::Entry, Kernel::bands>();
  };
  for_evaluate_kernels(add);
  for_cap_kernels(add);
  for_orient_kernels(add);
  for_gradient_kernels(add);
  for_gather_kernels(add);
  for_registry_kernels(add);
  return facts;
}

}  // namespace

const KernelFacts& find_facts(const char* name, int bands) {
  static const Facts facts = all_facts();
  return facts.at({name, bands});
}

}  // namespace zonal_bench
