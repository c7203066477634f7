// The gradient of the basis at a single direction, a degree at a time.
//
// One direction fills one lane of a packet. But the coefficients of a degree lie side by side, and those of its
// neighbours too, each at a fixed offset: written as loops over them, with the constants of the ladder in tables of the
// same order, the compiler computes eight and more at once. Against the kernel that it hands out one by one
// (evaluate_with_gradient with a sink), in float with AVX-512: 76 ns for 140 at 10 bands, 26 for 28 at 5.
#pragma once

#include <cstddef>

#include "evaluate.hpp"
#include "ladder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Below, the loops are too short.
inline constexpr int least_bands_in_rows = 5;
// Loops run on to a multiple of this, into the next degree, which overwrites it.
inline constexpr int row_step = 8;

// (2l+1) D_k of Y_l^m, m of either sign, as two terms for k = x and y, one for z. With Y = Y_(l-1), R^m = Y^-m:
//   x: x_plus Y^(m+1) + x_minus Y^(m-1)    y: y_plus R^(m+1) + y_minus R^(m-1)    z: same Y^m
template <int N, class T>
struct StepDownRows {
  static constexpr auto size = static_cast<std::size_t>(N * N + row_step);
  T x_plus[size] = {}, x_minus[size] = {}, y_plus[size] = {}, y_minus[size] = {}, same[size] = {};

  constexpr StepDownRows() {
    for (int l = 1; l < N; ++l) {
      for (int m = 0; m <= l; ++m) {
        const long double weight = SolidWeights::down(l);
        const T raise = T(weight * raise_down(l, m)), lower = T(m > 0 ? weight * lower_down(l, m) : 0);
        const int c = sh_index(l, m), s = sh_index(l, -m);
        x_plus[c] = raise, x_minus[c] = lower;
        y_plus[c] = raise, y_minus[c] = m > 1 ? -lower : T(0);  // sin(0 phi) is no harmonic
        same[c] = same[s] = T(weight * keep_down(l, m));
        if (m > 0) {
          x_minus[s] = raise, x_plus[s] = m > 1 ? lower : T(0);
          y_minus[s] = -raise, y_plus[s] = lower;
        }
      }
    }
  }
};
template <int N, class T>
inline constexpr StepDownRows<N, T> step_down_rows{};

// Basis values with room around them: loops read a little before the first and beyond the last, with the weight 0.
template <int N, class T>
struct PaddedRows {
  T storage[static_cast<std::size_t>(N * N + 2 * row_step)];

  PaddedRows() {
    for (int i = 0; i < row_step; ++i) storage[i] = storage[N * N + row_step + i] = T(0);
  }
  T* values() { return storage + row_step; }
};

template <int N, class T>
void gradient_in_rows(const T& x, const T& y, const T& z, Sh<N, T>& value, Sh<N, T> (&gradient)[3]) {
  constexpr auto& table = step_down_rows<N, T>;
  PaddedRows<N, T> basis_rows, mirrored_rows;
  T* const basis = basis_rows.values();
  T* const mirrored = mirrored_rows.values();
  evaluate<N>(x, y, z, [&](auto l, auto m, const T& y_lm) ZONAL_INLINE {
    basis[sh_index(l, m)] = y_lm;
    mirrored[sh_index(l, -m)] = y_lm;
  });

  T *by_x = gradient[0].values, *by_y = gradient[1].values, *by_z = gradient[2].values;
  by_x[0] = by_y[0] = by_z[0] = T(0);
  unroll<1, N>([&](auto l) ZONAL_INLINE {
    constexpr int first = sh_index(l, -l), size = 2 * l + 1, padded = (size + row_step - 1) / row_step * row_step;
    constexpr int end = first + (first + padded <= N * N ? padded : size);
    constexpr int down = 2 * l;  // from (l, m) to (l-1, m)
    const T degree = T(int{l}), lx = degree * x, ly = degree * y, lz = degree * z;
    for (int i = first; i < end; ++i) {
      by_x[i] = table.x_plus[i] * basis[i - down + 1] + table.x_minus[i] * basis[i - down - 1] - lx * basis[i];
    }
    for (int i = first; i < end; ++i) {
      by_y[i] = table.y_plus[i] * mirrored[i - down + 1] + table.y_minus[i] * mirrored[i - down - 1] - ly * basis[i];
    }
    for (int i = first; i < end; ++i) by_z[i] = table.same[i] * basis[i - down] - lz * basis[i];
  });
  for (int i = 0; i < N * N; ++i) value.values[i] = basis[i];
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
