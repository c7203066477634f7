// A kernel of each kind: roots, quotients, powers, exponentials, choices, sums that cancel.
#pragma once

#include <zonal/kernels/basis_kernels.hpp>
#include <zonal/kernels/gather_kernels.hpp>
#include <zonal/kernels/light_kernels.hpp>
#include <zonal/kernels/lobe_kernels.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/kernels/transform_kernels.hpp>

#include <cstddef>

#include "results.hpp"

namespace kernels_of_each_kind {

using namespace zonal::kernels;

inline constexpr int kBands = zonal::accuracy::run_bands;
using Kernels = KernelList<EvaluateWithGradient, Cap, CapDerivative, Phong, Gaussian, Orient, ReconstructAlong,
                           WindowFactors<zonal::Window::sinc>, SphereWithGradient, HvlRadiance<3>,
                           HvlRadiance<3, zonal::Horizon::smoothstep, zonal::Symmetry::zonal>>;

// In the namespace of the target, so that both units have their own.
template <class List>
std::vector<KernelResults> results_of(List list, const std::vector<std::vector<float>>& inputs, int runs) {
  std::vector<KernelResults> all;
  for_each_kernel(list, [&](auto entry) {
    using Entry = decltype(entry);
    const std::vector<float>& numbers = inputs[all.size()];
    const std::size_t size = numbers.size() / static_cast<std::size_t>(runs);
    DescribingIo<float> io([](const Parameter&) { return 0.5F; });
    Entry::template run<kBands>(io);
    std::size_t outputs = 0;
    for (const Parameter& p : io.parameters()) {
      outputs += p.direction == Direction::in ? 0 : static_cast<std::size_t>(p.size());
    }
    KernelResults found{Entry::name, std::vector<float>(outputs * static_cast<std::size_t>(runs))};
    for (std::size_t i = 0; i < static_cast<std::size_t>(runs); ++i) {
      run_plainly<Entry, kBands>(numbers.data() + i * size, found.results.data() + i * outputs);
    }
    all.push_back(found);
  });
  return all;
}

}  // namespace kernels_of_each_kind
