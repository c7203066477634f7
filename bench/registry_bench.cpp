// Every kernel of the registry.
#include "registry_kernels.hpp"

#include "run_kernel.hpp"

namespace zonal_bench {

void register_registry(const Effort& effort) {
  for_registry_kernels([&](auto kernel) {
    const RegisterKernel with{effort};
    with.add<decltype(kernel), float>();
    if constexpr (!is_quick) with.add<decltype(kernel), zonal::Packet<float, zonal::kNativeLanes>>();
  });
}

std::vector<std::string> registry_names() {
  std::vector<std::string> names;
  for_registry_kernels([&](auto kernel) { names.push_back(kernel_name(kernel.name, kernel.bands)); });
  return names;
}

}  // namespace zonal_bench
