// What the files compiled for one processor offer to the others: pointers and numbers, none of zonal's types, which are
// others in each of them.
#pragma once

#include <cstddef>

struct Kernels {
  // Five bands of RGB, channel innermost, at `count` unit vectors: three numbers each.
  void (*reconstruct)(const float (&coefficients)[75], const float* directions, std::size_t count, float* values);
  // E / pi of a sphere of radiance 1, centre (0, 0, height), at `count` places (x, y, 0) of a floor.
  void (*light_floor)(float height, float radius, const float* places, std::size_t count, float* values);
};

extern const Kernels kernels_sse2, kernels_avx2, kernels_avx512;
