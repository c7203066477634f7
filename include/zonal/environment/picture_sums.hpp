// What projections add up, and what they make of it.
//
// A sum over texels' middles, sum of L_i w_i Y(i), w_i their solid angles, does not give a constant picture one
// coefficient alone: the error of the sum of w_i Y(i) itself, 1.4e-5 of the first coefficient at 512 x 256, remains in
// the others. So the picture's mean goes into degree 0 and what differs from it is summed: sum of (L_i - mean) w_i
// Y(i), which is the first sum less mean times the second.
#pragma once

#include <cstddef>

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "picture.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// How a picture's texels become an integral. With `constant_exact` a picture of one radiance has one coefficient, in
/// any mapping, at any size; what no texel shows (a dead angle) counts as the mean of the rest. `middles` is the plain
/// sum over texels' middles: what other programs give, for comparisons.
enum class TexelRule { constant_exact, middles };

namespace detail {

// Coefficient i by constant_exact, from its sums of L w Y and w Y and from those of the first coefficient.
template <class C>
C constant_exact_coefficient(int i, const C& sum, double one, const C& first_sum, double first_one) {
  constexpr auto whole = rounded<double>(1 / zonal_normalisation<0>);  // the constant 1's coefficient
  const C mean = first_sum / first_one;
  return i == 0 ? mean * whole : sum - mean * one;
}

template <int N>
struct PictureSums {
  double radiance[std::size_t{N * N}][3] = {};  // of L w Y
  double one[std::size_t{N * N}] = {};          // of w Y
  PictureFaults faults;

  PictureSums& operator+=(const PictureSums& b) {
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) radiance[i][c] += b.radiance[i][c];
      one[i] += b.one[i];
    }
    faults += b.faults;
    return *this;
  }

  template <class C>
  Sh<N, C> finish(TexelRule rule) const {
    using T = number_t<C>;
    Sh<N, C> sh;
    for (int i = 0; i < N * N; ++i) {
      double value[3];
      for (int c = 0; c < 3; ++c) {
        value[c] = rule == TexelRule::middles
                       ? radiance[i][c]
                       : constant_exact_coefficient(i, radiance[i][c], one[i], radiance[0][c], one[0]);
      }
      sh.values[i] = C{static_cast<T>(value[0]), static_cast<T>(value[1]), static_cast<T>(value[2])};
    }
    return sh;
  }
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
