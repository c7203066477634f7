// Coefficients in 16 and in 8 bits, summed in float.
//
//   halves   2 bytes a coefficient. Each is off by at most 2^-11 of itself, or by 2^-25 below 2^-14; beyond 65504 it is
//            held at that, so scale what is brighter.
//   bytes    1 byte a coefficient and a scale, a half float, a channel or a band of it: c = scale * k, k = -127 to 127.
//            Each is off by at most scale / 2 = step / 2, and scale <= (1 + 2^-10) max|c| / 127 (or 2^-24 if more:
//            below 1e-5 or so bytes of a half's scale know less; beyond 8e6 they are held at that).
//
// A value is off by at most the sum over l of |dc|_l (2l+1) / sqrt(4pi), |dc|_l being the greatest error of a
// coefficient of degree l: sum_m |Y_l^m| <= sqrt(2l+1) |Y_l|, and |Y_l|^2 = (2l+1) / 4pi.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "../scalar/half.hpp"
#include "../transform/convolve.hpp"
#include "channels.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A channel of N bands in 2 N^2 bytes.
template <int N>
struct HalfSh {
  Half values[std::size_t{N * N}];
};

enum class ByteScale { channel, band };

/// A channel of N bands in N^2 bytes and one scale, or N of them: 11 or 15 bytes at 3 bands.
template <int N, ByteScale by = ByteScale::channel>
struct ByteSh {
  static constexpr int scales = by == ByteScale::channel ? 1 : N;
  Half scale[std::size_t{scales}];
  std::int8_t values[std::size_t{N * N}];
};

namespace detail {
inline Half to_finite_half(float number) { return to_half((std::min)((std::max)(number, -65504.0F), 65504.0F)); }
// Not below the number.
inline Half to_half_above(float number) {
  Half half = to_finite_half(number);
  if (to_float(half) < number && half.bits < 0x7bffU) ++half.bits;  // the next one, for it is not negative
  return half;
}
constexpr int scale_of_degree(ByteScale by, int l) { return by == ByteScale::channel ? 0 : l; }
}  // namespace detail

template <int N>
HalfSh<N> to_halves(const Sh<N, float>& sh) {
  HalfSh<N> r;
  for (int i = 0; i < N * N; ++i) r.values[i] = detail::to_finite_half(sh[i]);
  return r;
}
template <ByteScale by = ByteScale::channel, int N>
ByteSh<N, by> to_bytes(const Sh<N, float>& sh) {
  ByteSh<N, by> r{};
  float greatest[std::size_t{ByteSh<N, by>::scales}] = {};
  for (int l = 0; l < N; ++l) {
    float& most = greatest[detail::scale_of_degree(by, l)];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) most = (std::max)(most, std::abs(sh[i]));
  }
  for (int s = 0; s < r.scales; ++s) r.scale[s] = detail::to_half_above(greatest[s] / 127);
  for (int l = 0; l < N; ++l) {
    const float scale = to_float(r.scale[detail::scale_of_degree(by, l)]);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      const float k = scale > 0 ? sh[i] / scale : 0.0F;
      // Clamped first: nothing else is sure to fit. What is no number is 0.
      r.values[i] =
          static_cast<std::int8_t>(std::isnan(k) ? 0.0F : std::nearbyint((std::min)((std::max)(k, -127.0F), 127.0F)));
    }
  }
  return r;
}

template <int N>
Sh<N, float> to_floats(const HalfSh<N>& stored) {
  Sh<N, float> r{};
  for (int i = 0; i < N * N; ++i) r[i] = to_float(stored.values[i]);
  return r;
}
template <int N, ByteScale by>
Sh<N, float> to_floats(const ByteSh<N, by>& stored) {
  Sh<N, float> r{};
  for (int l = 0; l < N; ++l) {
    const float scale = to_float(stored.scale[detail::scale_of_degree(by, l)]);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) r[i] = scale * static_cast<float>(stored.values[i]);
  }
  return r;
}

/// No value is off by more for the storage, of coefficients within the range; what reconstruct rounds comes on top.
template <int N>
double value_error(const HalfSh<N>& stored) {
  double greatest = 0;
  for (const Half half : stored.values) {
    greatest = (std::max)(greatest, std::abs(static_cast<double>(to_float(half))));
  }
  return (std::max)(greatest * 0x1p-11, 0x1p-25) * N * N / std::sqrt(4 * double(kPi));
}
template <int N, ByteScale by>
double value_error(const ByteSh<N, by>& stored) {
  double sum = 0;
  for (int l = 0; l < N; ++l) {
    const Half scale = stored.scale[detail::scale_of_degree(by, l)];
    sum += 0.5 * static_cast<double>(to_float(scale)) * (2 * l + 1) / std::sqrt(4 * double(kPi));
  }
  return sum;
}

/// A value of coefficients that stand as numbers k_i of a scale each channel or band, scale * sum k_i Y_i: the scale is
/// multiplied once. The kernel, for any scalar: convolved with LambertLobe E / pi, without a kernel the function
/// itself.
template <ByteScale by, int N, class T, class Direction>
ZONAL_INLINE constexpr T reconstruct_scaled(const T (&scale)[std::size_t{ByteSh<N, by>::scales}],
                                            const Sh<N, T>& numbers, const Direction& direction, bool is_irradiance) {
  T by_degree[std::size_t{N}];
  const auto d = detail::as_direction<T>(direction);
  evaluate<N>(d.x, d.y, d.z, [&](auto l, auto m, const T& y) ZONAL_INLINE {
    const T term = numbers.values[sh_index(l, m)] * y;
    if constexpr (m == 0) {  // the first of its degree
      by_degree[l] = term;
    } else {
      by_degree[l] = by_degree[l] + term;
    }
  });
  T sum = T(0);
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    const T factor = is_irradiance ? detail::degree_factor<l, T>(LambertLobe{}) : T(1);
    const T part = factor * by_degree[l];
    sum = sum + (by == ByteScale::band ? scale[detail::scale_of_degree(by, l)] * part : part);
  });
  return by == ByteScale::band ? sum : scale[0] * sum;
}

/// Values, in float: of the function, and E / pi of radiance at a normal.
template <int N, class Direction>
float reconstruct(const HalfSh<N>& stored, const Direction& direction) {
  return reconstruct(to_floats(stored), direction);
}
template <int N, class Direction>
float irradiance_over_pi(const HalfSh<N>& stored, const Direction& normal) {
  return reconstruct_convolved(to_floats(stored), LambertLobe{}, normal);
}
namespace detail {
template <int N, ByteScale by, class Direction>
float value_of_bytes(const ByteSh<N, by>& stored, const Direction& direction, bool is_irradiance) {
  float scale[std::size_t{ByteSh<N, by>::scales}];
  Sh<N, float> numbers{};
  for (int s = 0; s < stored.scales; ++s) scale[s] = to_float(stored.scale[s]);
  for (int i = 0; i < N * N; ++i) numbers[i] = static_cast<float>(stored.values[i]);
  return reconstruct_scaled<by, N>(scale, numbers, direction, is_irradiance);
}
}  // namespace detail
template <int N, ByteScale by, class Direction>
float reconstruct(const ByteSh<N, by>& stored, const Direction& direction) {
  return detail::value_of_bytes(stored, direction, false);
}
template <int N, ByteScale by, class Direction>
float irradiance_over_pi(const ByteSh<N, by>& stored, const Direction& normal) {
  return detail::value_of_bytes(stored, normal, true);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
