#include "kernel_runs.hpp"

std::vector<same_bits::KernelRuns> same_bits::scene_kernels() { return all_of(zonal::kernels::SceneKernels{}); }
