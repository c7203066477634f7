#include "kernel_runs.hpp"

void append_scene_runs(std::vector<KernelRuns>& kernels) {
  zonal::kernels::for_each_kernel(zonal::kernels::SceneKernels{},
                                  [&](auto entry) { kernels.push_back(runs_of<decltype(entry)>()); });
}
