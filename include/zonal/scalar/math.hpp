// Trigonometry and its inverse, and the exponential, for any scalar, from + - * / sqrt alone: every target then
// computes the same thing. Some drivers' own acos is wrong by 1e-4, their exp by 10 ulp.
#pragma once

#include <limits>
#include <type_traits>

#include "constexpr_math.hpp"
#include "scalar.hpp"
#include "unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// R for any scalar but an integer: with these names in scope, exp(2) and acos(0) are the standard library's.
template <class T, class R>
using IfNotInteger = std::enable_if_t<!std::is_integral_v<T>, R>;

namespace detail {
// asin(s) = sum of c_k s^(2k+1), c_0 = 1, c_k = c_(k-1) (2k-1)^2 / (2k (2k+1)); for |s| <= 1/2 a term is less than a
// quarter of the one before.
template <int k>
inline constexpr long double arcsine_coefficient = arcsine_coefficient<k - 1>*(2 * k - 1) * (2 * k - 1) /
                                                   (2.0L * k * (2 * k + 1));
template <>
inline constexpr long double arcsine_coefficient<0> = 1;

// pi/2 in two parts, of which the first is a T.
template <class T>
inline constexpr lane_t<T> half_pi_high = static_cast<lane_t<T>>(kHalfPiDouble + kHalfPiRest);
template <class T>
inline constexpr long double half_pi_low = (kHalfPiDouble - static_cast<long double>(half_pi_high<T>)) + kHalfPiRest;

// 1 / k!, rounded once: k! is exact as far as it matters.
constexpr long double factorial(int k) { return k < 2 ? 1 : k * factorial(k - 1); }
template <int k>
inline constexpr long double inverse_factorial = 1 / factorial(k);
}  // namespace detail

namespace detail {
// asin(x) for 0 <= x <= 1.
template <class T>
ZONAL_INLINE constexpr T arcsine(const T& x) {
  // Beyond one half: asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2)), where (1 - x) / 2 is less than x^2.
  const T half_rest = T(0.5L) - T(0.5L) * x, root = sqrt(half_rest);
  const T s2 = minimum(half_rest, x * x), s = minimum(root, x);

  // asin(s) = s + s tail, the large part last; pi/2 in two parts, for beyond one half its rounding would show.
  constexpr int terms = digits_v<T> / 2 - 2;  // the first one left out is a tenth of an ulp
  constexpr auto last = rounded<T>(arcsine_coefficient<terms - 1>);
  T sum = T(last);
  unroll<1, terms - 1>([&](auto k) ZONAL_INLINE {
    constexpr auto coefficient = rounded<T>(arcsine_coefficient<terms - 1 - k>);
    sum = sum * s2 + T(coefficient);
  });
  const T tail = s2 * sum, twice = s + s;
  constexpr auto high = rounded<T>(static_cast<long double>(half_pi_high<T>));
  constexpr auto low = rounded<T>(half_pi_low<T>);
  return select(root < x, (T(high) - twice) - (twice * tail - T(low)), s + s * tail);
}
}  // namespace detail

/// asin(x) in radians for -1 <= x <= 1. Greatest error 2.1 ulp of the result.
template <class T>
ZONAL_INLINE constexpr IfNotInteger<T, T> asin(const T& x) {
  const T result = detail::arcsine(abs(x));
  return select(x < T(0), -result, result);
}

/// acos(x) in radians for -1 <= x <= 1. Greatest absolute error 1.5 ulp of pi.
template <class T>
ZONAL_INLINE constexpr IfNotInteger<T, T> acos(const T& x) {
  constexpr auto half_pi = rounded<T>(kPi / 2);
  return T(half_pi) - asin(x);
}

/// The angle from 0 to pi, in radians, with this cosine and this sine >= 0. Well conditioned for every angle.
template <class T>
ZONAL_INLINE constexpr IfNotInteger<T, T> angle_from(const T& cos_angle, const T& sin_angle) {
  constexpr auto pi = rounded<T>(kPi), half_pi = rounded<T>(kPi / 2);
  const T magnitude = abs(cos_angle);
  const T acute = select(sin_angle < magnitude, asin(sin_angle), T(half_pi) - asin(minimum(magnitude, T(1))));
  return select(cos_angle < T(0), T(pi) - acute, acute);
}

/// sin(x) and cos(x) for |x| <= pi/2, by their Taylor series. Greatest error 1.5 ulp of 1.
template <class T>
struct SinCos {
  T sine, cosine;
};
template <class T>
ZONAL_INLINE constexpr IfNotInteger<T, SinCos<T>> sin_cos(const T& x) {
  // Terms until the first one left out, (pi/2)^k / k!, is below a quarter ulp of 1.
  constexpr int last = digits_v<T> <= 24 ? 13 : digits_v<T> <= 53 ? 23 : 27;
  constexpr auto last_sine = rounded<T>(detail::inverse_factorial<last>);
  constexpr auto last_cosine = rounded<T>(detail::inverse_factorial<last - 1>);
  const T square = x * x;
  T sine = T(last_sine), cosine = T(last_cosine);
  unroll<0, (last - 1) / 2>([&](auto i) ZONAL_INLINE {
    constexpr int k = last - 2 - 2 * i;
    constexpr auto of_sine = rounded<T>(detail::inverse_factorial<k>);
    constexpr auto of_cosine = rounded<T>(detail::inverse_factorial<k - 1>);
    sine = T(of_sine) - square * sine;
    cosine = T(of_cosine) - square * cosine;
  });
  return {x * sine, cosine};
}

namespace detail {
// For e^-x, x >= 0, as a product over the binary digits of x down to 1/4, and the Taylor series of the rest.

// e^-(2^i / 4). By squaring again and again the error would double each time: only what double has no range for.
constexpr long double exponential_of_digit(int i) {
  constexpr long double known[] = {
      0.778800783071404868245170266978320647L,     0.606530659712633423603799534991180453L,
      0.367879441171442321595523770161460867L,     0.135335283236612691893999494972484403L,
      0.0183156388887341802937180212732412422L,    3.35462627902511838821389125780861019e-4L,
      1.12535174719259114513775179060127192e-7L,   1.26641655490941757231209041559650964e-14L,
      1.60381089054863785297608434213633538e-28L,  2.57220937264241482683953808360876908e-56L,
      6.61626105670948526102953080736206452e-112L, 4.37749103705305145412147276290218726e-223L,
  };
  return i < 12 ? known[i] : exponential_of_digit(i - 1) * exponential_of_digit(i - 1);
}

template <class T>
struct Exponential {
  using Limits = std::numeric_limits<lane_t<T>>;
  static constexpr int fraction_digits = 2;
  // Beyond it e^-x is less than the least number, denormal ones included.
  static constexpr long double greatest = (Limits::max_exponent + Limits::digits) * 0.693147180559945309417232121L;

  static constexpr long double power_of_digit(int i) {
    return i == 0 ? 1.0L / (1 << fraction_digits) : 2 * power_of_digit(i - 1);
  }
  static constexpr int digits = [] {
    int count = 0;
    while (power_of_digit(count) < greatest) ++count;
    return count;
  }();
  static constexpr int degree = [] {
    int count = 0;  // until the greatest term left out, 4^-k / k!, is an eighth of an ulp
    long double term = power_of_digit(0);
    for (; term > static_cast<long double>(Limits::epsilon()) / 8; term *= power_of_digit(0) / (count + 1)) ++count;
    return count;
  }();
};
}  // namespace detail

/// e^x. Greatest error 6 ulp of the result, where it is a normal number. Beyond the range of T: 0 and infinity.
template <class T>
ZONAL_INLINE constexpr IfNotInteger<T, T> exp(const T& x) {
  using Form = detail::Exponential<T>;
  constexpr int top = Form::digits - 1;
  constexpr auto greatest = rounded<T>(Form::greatest), top_power = rounded<T>(Form::power_of_digit(top));
  constexpr auto top_fall = rounded<T>(detail::exponential_of_digit(top));
  constexpr auto top_rise = rounded<T>(1 / detail::exponential_of_digit(top));
  const auto is_falling = x < T(0);

  // The factor of the greatest digit comes last, rising or falling: the reciprocal of what the others give is then far
  // from the least numbers, which some processors take for zero.
  T rest = minimum(abs(x), T(greatest)), product = T(1);
  const auto has_top = T(top_power) <= rest;
  rest = select(has_top, rest - T(top_power), rest);
  unroll<0, top>([&](auto i) ZONAL_INLINE {
    constexpr int digit = top - 1 - i;
    constexpr auto power = rounded<T>(Form::power_of_digit(digit));
    constexpr auto factor = rounded<T>(detail::exponential_of_digit(digit));
    const auto is_set = T(power) <= rest;
    rest = select(is_set, rest - T(power), rest);
    product = select(is_set, product * T(factor), product);
  });
  constexpr auto last = rounded<T>(detail::inverse_factorial<Form::degree>);
  T series = T(last);
  unroll<0, Form::degree>([&](auto i) ZONAL_INLINE {
    constexpr auto coefficient = rounded<T>(detail::inverse_factorial<Form::degree - 1 - i>);
    series = T(coefficient) - rest * series;
  });
  const T fall = product * series, result = select(is_falling, fall, T(1) / fall);
  return select(has_top, result * select(is_falling, T(top_fall), T(top_rise)), result);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
