// Every kernel of the registry at one number of bands.
#pragma once

#include <zonal/kernels/kernel_list.hpp>

#include "kernels.hpp"

namespace zonal_bench {

inline constexpr int registry_bands = 5;

template <class Visit>
void for_registry_kernels(Visit&& visit) {
  const auto visit_list = [&](auto list) {
    kernels::for_each_kernel(list, [&](auto entry) {
      using Entry = decltype(entry);
      visit(Timed < Entry, Entry::has_bands ? registry_bands : 1 > {});
    });
  };
  visit_list(kernels::BasisKernels{});
  visit_list(kernels::ColourKernels{});
  visit_list(kernels::SceneKernels{});
  visit_list(kernels::UnwrittenKernels{});
}

}  // namespace zonal_bench
