// A rotation as the matrix that it is, degree by degree: for one that turns several functions.
//
// rotate() by a Rotation passes through five sparse steps that wait for each other; a block of the matrix is a sum of
// its columns, which goes through registers without waiting: about half the time from 4 bands on, after a preparation
// of its own. Measured (AMD EPYC, AVX2, float; ns a function, and from how many functions on the preparation has paid):
//
//   bands               4     5     6     8    10
//   Rotation           19    28    48   106   201
//   dense              13    14    26    52    84
//   pays from, g++     17    13    16    13    13
//   pays from, clang++  3    15    39    23    40
//
// Colours are better turned by Rotation, three channels in the lanes of a register.
#pragma once

#include <cstddef>

#include "rotate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The blocks of degrees 1 to N - 1, column after column, each padded with zeros to whole registers. T: float, double.
template <int N, class T>
class DenseRotation {
  static_assert(N >= 1, "bands out of range: N >= 1");
  static_assert(is_builtin_scalar_v<T>, "numbers: float or double");

 public:
  explicit DenseRotation(const Rotation<(N > 1 ? N : 2), T>& rotation) {
    unroll<1, N>([&](auto l) ZONAL_INLINE {
      constexpr int size = 2 * l + 1, lanes = native_lanes_v<T>;
      using L = Lanes<T, lanes>;
      T* const block = columns_ + first<l>;
      const T odd = l % 2 == 1 ? rotation.parity() : T(1);
      for (int column = 0; column < size; column += lanes) {
        // As many unit functions as there are lanes, turned at once.
        L unit[std::size_t(size)], turned[std::size_t(size)];
        for (int i = 0; i < size; ++i) {
          T numbers[std::size_t(lanes)] = {};
          if (column <= i && i < column + lanes) numbers[i - column] = odd;
          unit[i] = L::load(numbers);
        }
        rotation.template rotate_degree<l>(unit, turned);
        for (int row = 0; row < padded<l>; ++row) {
          T numbers[std::size_t(lanes)] = {};
          if (row < size) turned[row].store(numbers);
          for (int i = 0; i < lanes && column + i < size; ++i) block[(column + i) * padded<l> + row] = numbers[i];
        }
      }
    });
  }

  /// As rotate(f, rotation), but for the order of additions: the same greatest error.
  Sh<N, T> operator()(const Sh<N, T>& f) const {
    T result[std::size_t(N * N + native_lanes_v<T>)];  // registers reach beyond the last
    result[0] = f.values[0];
    unroll<1, N>([&](auto l) ZONAL_INLINE {
      constexpr int registers = padded<l> / register_lanes<l>;
      using L = Lanes<T, register_lanes<l>>;
      const T* column = columns_ + first<l>;
      const T* const in = f.values + l * l;
      L sum[std::size_t(registers)];
      unroll<0, 2 * l + 1>([&](auto i) ZONAL_INLINE {
        unroll<0, registers>([&](auto k) ZONAL_INLINE {
          const L product = L::load(column + k * L::width) * L(in[i]);
          sum[k] = i == 0 ? product : sum[k] + product;
        });
        column += padded<l>;
      });
      // What is beyond the degree is written over by the next.
      unroll<0, registers>([&](auto k) ZONAL_INLINE { sum[k].store(result + l * l + k * L::width); });
    });
    Sh<N, T> r;
    for (int i = 0; i < N * N; ++i) r.values[i] = result[i];
    return r;
  }

 private:
  // Registers as wide as the target has them, or the narrowest that hold a column.
  static constexpr int lanes_for(int size, int lanes) {
    return lanes / 2 >= size && lanes > 2 ? lanes_for(size, lanes / 2) : lanes;
  }
  template <int l>
  static constexpr int register_lanes = lanes_for(2 * l + 1, native_lanes_v<T>);
  static constexpr int padded_size(int l) {
    const int lanes = lanes_for(2 * l + 1, native_lanes_v<T>);
    return (2 * l + lanes) / lanes * lanes;
  }
  template <int l>
  static constexpr int padded = padded_size(l);
  static constexpr int first_of(int l) {
    int sum = 0;
    for (int k = 1; k < l; ++k) sum += (2 * k + 1) * padded_size(k);
    return sum;
  }
  template <int l>
  static constexpr int first = first_of(l);

  alignas(64) T columns_[std::size_t(N > 1 ? first_of(N) : 1)];
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
