// ZH3: linear coefficients and one zonal coefficient of degree 2, about the axis that degree 1 has; five numbers a
// channel in place of nine, or four where that one is hallucinated [1].
//
//   f(w) = sum over l <= 1 of f_l^m Y_l^m(w) + z Y_2^0(cos of the angle between w and the axis)
//
// The axis is degree 1's, of luminance (BT.709, one for all channels) or of each channel. The z nearest to a degree 2
// is sqrt(4pi/5) sum_m f_2^m Y_2^m(axis), for |Y_2(axis)|^2 = 5/4pi. As the axis comes with degree 1, that may be bent
// towards the axis that suits degree 2: solve_zh3 finds the least error of irradiance in both together.
//
// Hallucinated, z = f_0 (0.08 r + 0.6 r^2), r = |f_1 . axis| / f_0, a fit to environments whose two constants are those
// of the authors' published shader [1, 2]. Light from one direction has r = sqrt(3), z / f_0 = sqrt(5); the fit has
// 1.939 there.
//
// [1] Roughton, Sloan, Silvennoinen, Iwanicki, Shirley, ZH3: Quadratic zonal harmonics, I3D 2024.
// [2] The same, "ZH3: Quadratic Zonal Harmonics", Shadertoy, ZH3Hallucinate_EvalIrradiance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../basis/evaluate.hpp"
#include "../transform/convolve.hpp"
#include "channels.hpp"
#include "least_value.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Whose degree 1 is the axis: luminance's, or each channel's own.
enum class Zh3Axis { luminance, channel };

/// Radiance in five numbers a channel; C is a number or a colour.
template <class C>
struct Zh3 {
  Sh<2, C> linear;
  C zonal;  // the coefficient z_2 about the axis
};

namespace detail {
// The vector of degree 1: what its value in a direction is the dot product with, over sqrt(3/4pi).
template <class T>
ZONAL_INLINE constexpr void vector_of_linear(const Sh<2, T>& linear, T (&v)[3]) {
  v[0] = -linear.values[3], v[1] = -linear.values[1], v[2] = linear.values[2];
}
// v as a unit vector, and its length; without a direction it is z.
template <class T>
ZONAL_DEVICE ZONAL_INLINE constexpr T to_unit(T (&v)[3]) {
  const T square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const auto is_none = square < T(1e-30L);
  const T length = sqrt(maximum(square, T(1e-30L)));
  v[0] = select(is_none, T(0), v[0] / length);
  v[1] = select(is_none, T(0), v[1] / length);
  v[2] = select(is_none, T(1), v[2] / length);
  return select(is_none, T(0), length);
}
template <class T>
ZONAL_INLINE constexpr T along(const T (&axis)[3], const Direction3<T>& d) {
  return axis[0] * d.x + axis[1] * d.y + axis[2] * d.z;
}
// z Y_2^0, Y_2^0 = sqrt(5/16pi) (3 c^2 - 1)
template <class T>
ZONAL_INLINE constexpr T zonal_value(const T& zonal, const T& cosine) {
  constexpr auto scale = rounded<T>(constexpr_sqrt(5 / (16 * kPi)));
  return zonal * (T(scale) * (T(3) * cosine * cosine - T(1)));
}
}  // namespace detail

/// The axis of a channel, a unit vector: where its degree 1 is greatest. z where it is nowhere.
template <class T>
ZONAL_DEVICE ZONAL_INLINE constexpr void linear_axis(const Sh<2, T>& linear, T (&axis)[3]) {
  detail::vector_of_linear(linear, axis);
  detail::to_unit(axis);
}

/// A channel's radiance in a direction, a unit vector as the axis is: the kernel, for any scalar.
template <class T, class Direction>
ZONAL_INLINE constexpr T reconstruct_zh3(const Sh<2, T>& linear, const T& zonal, const T (&axis)[3],
                                         const Direction& direction) {
  const auto d = detail::as_direction<T>(direction);
  return reconstruct(linear, direction) + detail::zonal_value(zonal, detail::along(axis, d));
}

/// E / pi at a normal, the degrees times 1, 2/3, 1/4.
template <class T, class Direction>
ZONAL_INLINE constexpr T irradiance_zh3_over_pi(const Sh<2, T>& linear, const T& zonal, const T (&axis)[3],
                                                const Direction& normal) {
  const auto d = detail::as_direction<T>(normal);
  return reconstruct_convolved(linear, LambertLobe{}, normal) +
         T(0.25L) * detail::zonal_value(zonal, detail::along(axis, d));
}

/// The zonal coefficient that linear ones suggest [1, 2]; 0 where f_0 is not positive.
template <class T>
ZONAL_INLINE constexpr T hallucinated_zonal(const Sh<2, T>& linear, const T (&axis)[3]) {
  T v[3];
  detail::vector_of_linear(linear, v);
  const T along_axis = abs(v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2]);
  const T mean = maximum(linear.values[0], T(1e-30L));
  return along_axis * (T(0.08L) + T(0.6L) * (along_axis / mean));
}

/// The zonal coefficient about an axis that is nearest to degree 2 of a channel.
template <class T>
ZONAL_INLINE constexpr T nearest_zonal(const Sh<3, T>& sh, const T (&axis)[3]) {
  constexpr auto to_zonal = rounded<T>(detail::zonal_to_degree<2>);
  T sum = T(0);
  evaluate<3>(axis[0], axis[1], axis[2], [&](auto l, auto m, const T& y) ZONAL_INLINE {
    if constexpr (l == 2) sum = sum + sh.values[sh_index(l, m)] * y;
  });
  return T(to_zonal) * sum;
}

namespace detail {
// The axis of a channel of numbers or colours.
template <class C>
constexpr void zh3_axis(const Sh<2, C>& linear, Zh3Axis kind, int which, number_t<C> (&axis)[3]) {
  using T = number_t<C>;
  linear_axis(kind == Zh3Axis::channel ? take_channel<T>(linear, which) : luminance_of<T>(linear), axis);
}
// body(channel, axis) of each channel.
template <class C, class Body>
constexpr void for_each_axis(const Sh<2, C>& linear, Zh3Axis kind, const Body& body) {
  number_t<C> axis[3] = {};
  for (int c = 0; c < channels_v<C>; ++c) {
    if (c == 0 || kind == Zh3Axis::channel) zh3_axis(linear, kind, c, axis);
    body(c, axis);
  }
}
}  // namespace detail

/// The first two bands, and the zonal coefficient nearest to the third.
template <class C>
constexpr Zh3<C> project_zh3(const Sh<3, C>& radiance, Zh3Axis kind = Zh3Axis::luminance) {
  Zh3<C> r{with_bands<2>(radiance), detail::zero<C>(0)};
  detail::for_each_axis(r.linear, kind, [&](int c, const auto& axis) {
    detail::channel_of(r.zonal, c) = nearest_zonal(detail::take_channel<detail::number_t<C>>(radiance, c), axis);
  });
  return r;
}

/// The first two bands, and the zonal coefficient that they suggest.
template <class C>
constexpr Zh3<C> hallucinate_zh3(const Sh<2, C>& radiance, Zh3Axis kind = Zh3Axis::luminance) {
  Zh3<C> r{radiance, detail::zero<C>(0)};
  detail::for_each_axis(radiance, kind, [&](int c, const auto& axis) {
    detail::channel_of(r.zonal, c) = hallucinated_zonal(detail::take_channel<detail::number_t<C>>(radiance, c), axis);
  });
  return r;
}

namespace detail {
// kernel(linear, zonal, axis) of each channel.
template <class C, class Kernel>
constexpr C by_channel(const Zh3<C>& zh3, Zh3Axis kind, const Kernel& kernel) {
  C value = zh3.zonal;
  for_each_axis(zh3.linear, kind, [&](int c, const auto& axis) {
    channel_of(value, c) = kernel(take_channel<number_t<C>>(zh3.linear, c), channel_of(zh3.zonal, c), axis);
  });
  return value;
}
}  // namespace detail

/// Radiance in a direction.
template <class C, class Direction>
constexpr C reconstruct(const Zh3<C>& zh3, const Direction& direction, Zh3Axis kind = Zh3Axis::luminance) {
  return detail::by_channel(zh3, kind, [&](const auto& linear, const auto& zonal, const auto& axis) {
    return reconstruct_zh3(linear, zonal, axis, direction);
  });
}

/// E / pi at a normal.
template <class C, class Direction>
constexpr C irradiance_over_pi(const Zh3<C>& zh3, const Direction& normal, Zh3Axis kind = Zh3Axis::luminance) {
  return detail::by_channel(zh3, kind, [&](const auto& linear, const auto& zonal, const auto& axis) {
    return irradiance_zh3_over_pi(linear, zonal, axis, normal);
  });
}

/// As coefficients of three bands.
template <class C>
constexpr Sh<3, C> expand(const Zh3<C>& zh3, Zh3Axis kind = Zh3Axis::luminance) {
  using T = detail::number_t<C>;
  Sh<3, C> r = with_bands<3>(zh3.linear);
  detail::for_each_axis(zh3.linear, kind, [&](int c, const auto& axis) {
    constexpr auto to_degree = rounded<T>(detail::zonal_to_degree<2>);
    const T zonal = T(to_degree) * detail::channel_of(zh3.zonal, c);
    evaluate<3>(axis[0], axis[1], axis[2], [&](auto l, auto m, const T& y) {
      if constexpr (l == 2) detail::channel_of(r.values[sh_index(l, m)], c) = zonal * y;
    });
  });
  return r;
}

namespace detail {
// The axis a that loses least: the squared error of E / pi is a constant less
//
//   (2/3)^2 (v . a)^2 / sum w_c^2 + (1/4)^2 4pi/5 sum_c (a' A_c a)^2,
//
// for degree 1 changes least, by w_c (v - (v.a) a) / sum w_c^2, if luminance's v is to end along a, and A_c is the form
// of degree 2.
template <std::size_t Count>
std::array<double, 3> best_axis(const double (&v)[3], const double (&forms)[Count][3][3], double weights) {
  const double of_vector = 4.0 / 9 / weights, of_form = double(kPi) / 20;
  const auto gain = [&](const std::array<double, 3>& a, std::array<double, 3>& slope) {
    const double along = v[0] * a[0] + v[1] * a[1] + v[2] * a[2];
    double sum = of_vector * along * along;
    for (std::size_t i = 0; i < 3; ++i) slope[i] = 2 * of_vector * along * v[i];
    for (const auto& form : forms) {
      double turned[3], value = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        turned[i] = form[i][0] * a[0] + form[i][1] * a[1] + form[i][2] * a[2];
        value += turned[i] * a[i];
      }
      sum += of_form * value * value;
      for (std::size_t i = 0; i < 3; ++i) slope[i] += 4 * of_form * value * turned[i];
    }
    return sum;
  };
  double bend = 2 * of_vector * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (const auto& form : forms) {
    for (const auto& row : form) {
      for (const double x : row) bend += 12 * of_form * x * x;
    }
  }
  bend *= 2;  // of the gain in space, and of the sphere
  // Up the slope, by steps that cannot overshoot; the gain at the last but one.
  const auto climb = [&](std::array<double, 3>& a, int steps) {
    double value = 0;
    std::array<double, 3> slope{};
    for (int step = 0; step < steps; ++step) {
      value = gain(a, slope);
      const double radial = slope[0] * a[0] + slope[1] * a[1] + slope[2] * a[2];
      double square = 0, change = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double move = (slope[i] - radial * a[i]) / bend;
        change += move * move, a[i] += move, square += a[i] * a[i];
      }
      for (double& x : a) x /= std::sqrt(square);
      if (change < 1e-18) break;
    }
    return value;
  };
  // The gain of an axis is that of its opposite: starts over half of the directions, and degree 1's own.
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  std::array<double, 3> best{v[0] / length, v[1] / length, v[2] / length};
  double best_gain = climb(best, 30);
  for (int start = 14; start < 27; ++start) {  // 13 is the middle of a cube of 27
    std::array<double, 3> a{double(start / 9 - 1), double(start / 3 % 3 - 1), double(start % 3 - 1)};
    const double size = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (double& x : a) x /= size;
    const double value = climb(a, 30);
    if (value > best_gain) best_gain = value, best = a;
  }
  climb(best, 5000);
  return best;
}

template <int Count, class C>
void solve_zh3(const Sh<3, C>& radiance, int first, Zh3<C>& result) {
  double v[3] = {}, forms[std::size_t{Count}][3][3], weights = 0;
  const auto weight = [](int c) { return Count == 1 ? 1.0 : luminance_weight<C>(c); };
  for (int c = 0; c < Count; ++c) {
    const Sh<3, double> f = take_channel<double>(radiance, first + c);
    v[0] -= weight(c) * f[3], v[1] -= weight(c) * f[1], v[2] += weight(c) * f[2], weights += weight(c) * weight(c);
    const double degree[5] = {f[4], f[5], f[6], f[7], f[8]};
    quadratic_form(degree, forms[c]);
  }
  if (!(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > 0)) return;
  const std::array<double, 3> a = best_axis(v, forms, weights);
  const double axis[3] = {a[0], a[1], a[2]};
  const double length = v[0] * a[0] + v[1] * a[1] + v[2] * a[2];
  for (int c = 0; c < Count; ++c) {
    using T = number_t<C>;
    const double by = weight(c) / weights;
    channel_of(result.linear[3], first + c) += static_cast<T>(by * (v[0] - length * a[0]));
    channel_of(result.linear[1], first + c) += static_cast<T>(by * (v[1] - length * a[1]));
    channel_of(result.linear[2], first + c) -= static_cast<T>(by * (v[2] - length * a[2]));
    channel_of(result.zonal, first + c) =
        static_cast<T>(nearest_zonal(take_channel<double>(radiance, first + c), axis));
  }
}
}  // namespace detail

/// The ZH3 with the least squared error of irradiance against three bands (with Zh3Axis::luminance of the sum over
/// channels): degree 1 may change for a better axis. For baking: some 50 us.
template <class C>
Zh3<C> solve_zh3(const Sh<3, C>& radiance, Zh3Axis kind = Zh3Axis::luminance) {
  constexpr int count = detail::channels_v<C>;
  Zh3<C> r = project_zh3(radiance, kind);
  if (kind == Zh3Axis::luminance) {
    detail::solve_zh3<count>(radiance, 0, r);
  } else {
    for (int c = 0; c < count; ++c) detail::solve_zh3<1>(radiance, c, r);
  }
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
