// The plain sum over texels, kept as the reference.
#pragma once

#include "../basis/evaluate.hpp"
#include "environment.hpp"
#include "picture_sums.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What project() gives, texel by texel in double: the basis at each texel's middle, times its radiance and its solid
/// angle. Slow, and obvious.
template <int N, class C = Rgb<double>, class Element>
Sh<N, C> project_by_texel(const Environment<Element>& environment, TexelRule rule = TexelRule::constant_exact,
                          PictureFaults* faults = nullptr) {
  detail::PictureSums<N> sums;
  environment.visit([&](const auto& mapping) {
    for (int row = 0; row < environment.height(); ++row) {
      for (int column = 0; column < environment.width(); ++column) {
        if (!mapping.has_direction(column, row)) continue;
        const Rgb<float> radiance = environment.radiance(column, row, sums.faults);
        const Sh<N, double> y = evaluate<N>(mapping.direction(column + 0.5, row + 0.5));
        const double solid_angle = mapping.solid_angle(column, row);
        for (int i = 0; i < N * N; ++i) {
          const double weight = solid_angle * y.values[i];
          for (int c = 0; c < 3; ++c) sums.radiance[i][c] += weight * double(radiance[c]);
          sums.one[i] += weight;
        }
      }
    }
  });
  if (faults != nullptr) *faults = sums.faults;
  return sums.template finish<C>(rule);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
