// The gradient of the basis at a single direction, a degree at a time, and the ladder's steps for any scalar.
//
// One direction fills one lane of a packet. But the coefficients of a degree lie side by side, and those of its
// neighbours too, each at a fixed offset: written as loops over them, with the constants of the ladder in tables of the
// same order, the compiler computes eight and more at once. Against the kernel that it hands out one by one
// (evaluate_with_gradient with a sink), in float with AVX-512: 76 ns for 140 at 10 bands, 26 for 28 at 5.
#pragma once

#include <cstddef>
#include <limits>

#include "evaluate.hpp"
#include "ladder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// With fewer bands the loops are too short. On a graphics processor the tables are out of reach.
#if defined(__CUDA_ARCH__)
inline constexpr int least_bands_in_rows = (std::numeric_limits<int>::max)();
inline constexpr int least_hessian_in_rows = least_bands_in_rows;
#else
inline constexpr int least_bands_in_rows = 5;
inline constexpr int least_hessian_in_rows = 8;
#endif
// Loops run on to a multiple of this, into the next degree, which overwrites it.
inline constexpr int row_step = 8;

// The weighted step from degree l to a neighbour, one degree up or down, for m of either sign: two terms for x and y,
// one for z. With Y of the neighbour's degree, R^m = Y^-m:
//   x: x_plus Y^(m+1) + x_minus Y^(m-1)    y: y_plus R^(m+1) + y_minus R^(m-1)    z: same Y^m
template <int N, class T, class Weights, bool is_up>
struct StepRows {
  static constexpr auto size = static_cast<std::size_t>(N * N + row_step);
  constant_t<T> x_plus[size] = {}, x_minus[size] = {}, y_plus[size] = {}, y_minus[size] = {}, same[size] = {};

  constexpr StepRows() {
    for (int l = 0; l < N; ++l) {
      const int weight = is_up ? Weights::up(l) : Weights::down(l);
      if (weight == 0 || (l == 0 && !is_up)) continue;
      for (int m = 0; m <= l; ++m) {
        const auto keep = rounded<T>(weight * (is_up ? keep_up(l, m) : keep_down(l, m)));
        const auto raise = rounded<T>(weight * (is_up ? raise_up(l, m) : raise_down(l, m)));
        const auto lower = rounded<T>(m == 0 ? 0 : weight * (is_up ? lower_up(l, m) : lower_down(l, m)));
        const int c = sh_index(l, m), s = sh_index(l, -m);
        x_plus[c] = raise, x_minus[c] = lower;
        y_plus[c] = raise, y_minus[c] = m > 1 ? -lower : 0;  // sin(0 phi) is no harmonic
        same[c] = same[s] = keep;
        if (m > 0) {
          x_minus[s] = raise, x_plus[s] = m > 1 ? lower : 0;
          y_minus[s] = -raise, y_plus[s] = lower;
        }
      }
    }
  }
};
template <int N, class T, class Weights, bool is_up>
inline constexpr StepRows<N, T, Weights, is_up> step_rows{};

// Basis values with room around them: loops read a little before the first and beyond the last, with the weight 0.
template <int N, class T>
struct PaddedRows {
  T storage[static_cast<std::size_t>(N * N + 2 * row_step)];

  PaddedRows() {
    for (int i = 0; i < row_step; ++i) storage[i] = storage[N * N + row_step + i] = T(0);
  }
  T* values() { return storage + row_step; }
  const T* values() const { return storage + row_step; }
};

// To arrays of N*N numbers each.
template <int N, class T>
void gradient_in_rows(const T& x, const T& y, const T& z, T* value, T* by_x, T* by_y, T* by_z) {
  constexpr auto& table = step_rows<N, T, SolidWeights, false>;
  PaddedRows<N, T> basis_rows, mirrored_rows;
  T* const basis = basis_rows.values();
  T* const mirrored = mirrored_rows.values();
  evaluate<N>(x, y, z, [&](auto l, auto m, const T& y_lm) ZONAL_INLINE {
    basis[sh_index(l, m)] = y_lm;
    mirrored[sh_index(l, -m)] = y_lm;
  });

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
  for (int i = 0; i < N * N; ++i) value[i] = basis[i];
}

// The gradients of N degrees from the values of their neighbours, to where x, y and z lead; null where one is not asked
// for.
template <int N, class Weights, int M, class T>
void ladder_in_rows(const PaddedRows<M, T>& rows, T* x, T* y, T* z) {
  static_assert(M > N, "a neighbour is missing");
  constexpr auto& up = step_rows<N, T, Weights, true>;
  constexpr auto& down = step_rows<N, T, Weights, false>;
  const T* values = rows.values();
  for (int l = 0; l < N; ++l) {
    const int centre = sh_index(l, 0), above = sh_index(l + 1, 0), below = l * (l - 1);
    for (int m = -l; x && m <= l; ++m) {
      const int i = centre + m;
      x[i] = (T(up.x_plus[i]) * values[above + m + 1] + T(up.x_minus[i]) * values[above + m - 1]) +
             (T(down.x_plus[i]) * values[below + m + 1] + T(down.x_minus[i]) * values[below + m - 1]);
    }
    for (int m = -l; y && m <= l; ++m) {
      const int i = centre + m;
      y[i] = (T(up.y_plus[i]) * values[above - m - 1] + T(up.y_minus[i]) * values[above - m + 1]) +
             (T(down.y_plus[i]) * values[below - m - 1] + T(down.y_minus[i]) * values[below - m + 1]);
    }
    for (int m = -l; z && m <= l; ++m) {
      const int i = centre + m;
      z[i] = T(up.same[i]) * values[above + m] + T(down.same[i]) * values[below + m];
    }
  }
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
