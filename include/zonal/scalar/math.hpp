// Trigonometry and its inverse, and the exponential, for any scalar, from + - * / sqrt alone: every target then
// computes the same thing. Some drivers' own acos is wrong by 1e-4, their exp by 10 ulp.
#pragma once

#include "constexpr_math.hpp"
#include "scalar.hpp"
#include "unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// asin(s) = sum of c_k s^(2k+1), c_0 = 1, c_k = c_(k-1) (2k-1)^2 / (2k (2k+1)); for |s| <= 1/2 a term is less than a
// quarter of the one before.
template <class T>
struct ArcsineSeries {
  static constexpr int terms = digits_v<T> / 2 - 2;  // the first one left out is a tenth of an ulp
  long double coefficient[static_cast<std::size_t>(terms)] = {};
  constexpr ArcsineSeries() {
    coefficient[0] = 1;
    for (int k = 1; k < terms; ++k) {
      coefficient[k] = coefficient[k - 1] * (2 * k - 1) * (2 * k - 1) / (2.0L * k * (2 * k + 1));
    }
  }
};
template <class T>
inline constexpr ArcsineSeries<T> arcsine_series{};
}  // namespace detail

/// asin(x) in radians for -1 <= x <= 1. Greatest error 2 ulp of the result.
template <class T>
ZONAL_INLINE constexpr T asin(const T& x) {
  // Beyond one half: asin(|x|) = pi/2 - 2 asin(sqrt((1 - |x|) / 2)).
  const T magnitude = abs(x);
  const auto is_large = magnitude > T(0.5L);
  const T half_rest = T(0.5L) * (T(1) - magnitude);
  const T s2 = select(is_large, half_rest, magnitude * magnitude);
  const T s = select(is_large, sqrt(half_rest), magnitude);

  // asin(s) = s + tail, the large part last; pi/2 in two parts, for beyond one half its rounding would show.
  constexpr auto& series = detail::arcsine_series<T>;
  T sum = T(series.coefficient[series.terms - 1]);
  unroll<1, series.terms - 1>([&](auto k)
                                  ZONAL_INLINE { sum = sum * s2 + T(series.coefficient[series.terms - 1 - k]); });
  const T tail = s * (s2 * sum);
  constexpr long double half_pi = static_cast<long double>(static_cast<lane_t<T>>(kPi / 2));
  const T large = (T(half_pi) - (s + s)) - (tail + tail - T(kPi / 2 - half_pi));
  const T result = select(is_large, large, s + tail);
  return select(x < T(0), -result, result);
}

/// acos(x) in radians for -1 <= x <= 1. Greatest absolute error 1.5 ulp of pi.
template <class T>
ZONAL_INLINE constexpr T acos(const T& x) {
  return T(kPi / 2) - asin(x);
}

/// The angle from 0 to pi, in radians, with this cosine and this sine >= 0. Well conditioned for every angle.
template <class T>
ZONAL_INLINE constexpr T angle_from(const T& cos_angle, const T& sin_angle) {
  const T magnitude = abs(cos_angle);
  const T acute = select(sin_angle < magnitude, asin(sin_angle), T(kPi / 2) - asin(minimum(magnitude, T(1))));
  return select(cos_angle < T(0), T(kPi) - acute, acute);
}

/// sin(x) and cos(x) for |x| <= pi/2, by their Taylor series. Greatest error 1.5 ulp of 1.
template <class T>
struct SinCos {
  T sine, cosine;
};
template <class T>
ZONAL_INLINE constexpr SinCos<T> sin_cos(const T& x) {
  // Terms until the first one left out, (pi/2)^k / k!, is below a quarter ulp of 1.
  constexpr int last = digits_v<T> <= 24 ? 13 : digits_v<T> <= 53 ? 23 : 27;
  constexpr auto inverse_factorial = [](int k) {
    long double f = 1;
    for (int i = 2; i <= k; ++i) f /= i;
    return f;
  };
  const T square = x * x;
  T sine = T(inverse_factorial(last)), cosine = T(inverse_factorial(last - 1));
  unroll<0, (last - 1) / 2>([&](auto i) ZONAL_INLINE {
    constexpr int k = last - 2 - 2 * i;
    sine = T(inverse_factorial(k)) - square * sine;
    cosine = T(inverse_factorial(k - 1)) - square * cosine;
  });
  return {x * sine, cosine};
}

namespace detail {
// For e^-x, x >= 0, as a product over the binary digits of x down to 1/4, and the Taylor series of the rest.
template <class T>
struct ExponentialTable {
  using Limits = std::numeric_limits<lane_t<T>>;
  static constexpr int fraction_digits = 2;
  static constexpr long double greatest = (Limits::max_exponent + Limits::digits) * 0.693147180559945309417232121L;

  int digits = 0, degree = 0;  // 2^-fraction_digits 2^digits is beyond `greatest`
  long double power[24] = {}, factor[24] = {}, inverse_factorial[24] = {};

  constexpr ExponentialTable() {
    inverse_factorial[0] = 1;
    for (int k = 1; k < 24; ++k) inverse_factorial[k] = inverse_factorial[k - 1] / k;
    const auto greatest_term = [this](int k) {
      long double term = inverse_factorial[k];
      for (int i = 0; i < k; ++i) term /= 1 << fraction_digits;
      return term;
    };
    while (greatest_term(degree + 1) > static_cast<long double>(Limits::epsilon()) / 8) ++degree;

    long double step = 1.0L / (1 << fraction_digits), e = 0;  // e^-step by its series
    for (int k = 23; k >= 0; --k) e = inverse_factorial[k] - step * e;
    for (; step < greatest; step *= 2, e *= e) {
      power[digits] = step;
      factor[digits++] = e;
    }
  }
};
template <class T>
inline constexpr ExponentialTable<T> exponential_table{};
}  // namespace detail

/// e^x. Greatest error 6 ulp of the result, where it is a normal number. Beyond the range of T: 0 and infinity.
template <class T>
ZONAL_INLINE constexpr T exp(const T& x) {
  constexpr auto& table = detail::exponential_table<T>;
  T rest = minimum(abs(x), T(table.greatest)), product = T(1);
  unroll<0, table.digits>([&](auto i) ZONAL_INLINE {
    constexpr int digit = table.digits - 1 - i;
    const auto is_set = T(table.power[digit]) <= rest;
    rest = select(is_set, rest - T(table.power[digit]), rest);
    product = select(is_set, product * T(table.factor[digit]), product);
  });
  T series = T(table.inverse_factorial[table.degree]);
  unroll<0, table.degree>(
      [&](auto i) ZONAL_INLINE { series = T(table.inverse_factorial[table.degree - 1 - i]) - rest * series; });
  const T fall = product * series;
  return select(x < T(0), fall, T(1) / fall);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
