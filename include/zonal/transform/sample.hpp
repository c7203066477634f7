// Directions drawn in proportion to a non-negative function that spherical harmonics give, without table or rejection.
//
// Over a circle of constant z only the order 0 is left of the function's integral, so the distribution of z is that of
// the zonal part, and its integral a sum of Legendre polynomials again:
//   integral from -1 to z of P_l = (P_(l+1)(z) - P_(l-1)(z)) / (2l+1)
// On the circle the function is a_0 + sum of a_m cos(m phi) + b_m sin(m phi), whose integral is of the same form. Both
// are increasing where the function is positive, and are inverted by Newton's method inside a bracket.
#pragma once

#include <cmath>
#include <limits>

#include "../basis/evaluate.hpp"
#include "../basis/normalisation.hpp"
#include "dot.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

template <class T>
struct ValueAndSlope {
  T value, slope;
};

/// Where the function f, which increases from 0 at `low` to `total` at `high`, is share * total, to rounding.
template <class T, class F>
T solve_increasing(const F& f, T share, T total, T low, T high) {
  constexpr int most_steps =
      60;  // at zeros of the slope each leaves a third of the distance, elsewhere four are enough
  constexpr T epsilon = std::numeric_limits<T>::epsilon();
  const T target = share * total, tolerance = epsilon * total, smallest = epsilon * (high - low);
  T x = low + share * (high - low);
  for (int step = 0; step < most_steps && high - low > smallest; ++step) {
    const ValueAndSlope<T> at = f(x);
    const T missing = target - at.value;
    if (std::abs(missing) <= tolerance) break;
    (missing > T(0) ? low : high) = x;
    const T newton = x + missing / at.slope;
    x = low < newton && newton < high ? newton : (low + high) / T(2);
  }
  return x;
}

}  // namespace detail

/// A direction and its density, 1/sr.
template <class T>
struct DirectionSample {
  T x, y, z, pdf;
};

/// Draws directions in proportion to f >= 0, float or double; f in proportion to radiance times cosine, say. Where f is
/// negative, as a truncated series can be, its density counts as zero, and the draws are no longer in proportion:
/// window it first (window.hpp). f whose integral is not a positive number gives uniform directions.
template <int N, class T>
class ShSampler {
 public:
  explicit ShSampler(const Sh<N, T>& f) {
    const T integral = f.values[0] * T(rounded<T>(detail::zonal_to_degree<0>));  // sqrt(4 pi) f_00
    is_uniform_ = !(integral > T(0) && integral <= (std::numeric_limits<T>::max)());
    if (is_uniform_) {
      f_.values[0] = T(rounded<T>(detail::zonal_normalisation<0>));
    } else {
      f_ = f / integral;
    }
    unroll<0, N>([&](auto l) {
      constexpr long double degree = 2 * kPi * detail::zonal_normalisation<l> / (2 * l + 1);
      constexpr int before = l > 0 ? l - 1 : 0;
      const T zonal = f_.values[sh_index(l, 0)];
      below_.values[l + 1] += zonal * T(rounded<T>(degree * detail::zonal_to_degree<l + 1>));
      below_.values[before] += zonal * T(rounded<T>((l > 0 ? -degree : degree) * detail::zonal_to_degree<before>));
    });
  }

  /// Not in proportion to anything, for f had no positive integral.
  bool is_uniform() const { return is_uniform_; }

  /// u and v in [0, 1), uniform and independent; others are taken for the nearest such number, NaN for 0. The
  /// distributions of z and of phi are met to 4 epsilon times the sum of the coefficients' magnitudes.
  DirectionSample<T> sample(T u, T v) const {
    u = minimum(maximum(T(0), u), T(1)), v = minimum(maximum(T(0), v), T(1));  // NaN is 0 by this order only
    const T z = detail::solve_increasing([&](T at) { return below(at); }, u, T(1), T(-1), T(1));
    const T sine = std::sqrt((T(1) - z) * (T(1) + z));
    T a[std::size_t(N)] = {}, b[std::size_t(N)] = {};
    evaluate_even<N>(sine, z, [&](auto l, auto m, const T& value) {
      a[m] += f_.values[sh_index(l, m)] * value;
      if constexpr (m > 0) b[m] += f_.values[sh_index(l, -m)] * value;
    });
    const auto circle = [&](T at) { return before(a, b, at); };
    const T phi = a[0] > T(0) ? detail::solve_increasing(circle, v, turn_ * a[0], T(0), turn_) : v * turn_;
    const detail::Direction3<T> direction{sine * std::cos(phi), sine * std::sin(phi), z};
    return {direction.x, direction.y, direction.z, pdf(direction)};
  }

  /// The density, 1/sr, of a unit vector.
  template <class Direction>
  T pdf(const Direction& direction) const {
    const T value = reconstruct(f_, detail::as_direction<T>(direction));
    return value > T(0) ? value : T(0);
  }

 private:
  static constexpr T turn_ = static_cast<T>(2 * kPi);

  /// How much of the integral lies below z.
  detail::ValueAndSlope<T> below(T z) const {
    detail::ValueAndSlope<T> sum{T(0), T(0)};
    evaluate_zonal<N + 1>(z, [&](auto l, const T& y) {
      sum.value += below_.values[l] * y;
      if constexpr (l < N) sum.slope += f_.values[sh_index(l, 0)] * y;
    });
    sum.slope *= turn_;
    return sum;
  }

  /// How much of the circle's integral lies before phi.
  static detail::ValueAndSlope<T> before(const T (&a)[std::size_t(N)], const T (&b)[std::size_t(N)], T phi) {
    const T cos_phi = std::cos(phi), sin_phi = std::sin(phi);
    detail::ValueAndSlope<T> sum{a[0] * phi, a[0]};
    T c = cos_phi, s = sin_phi;
    for (int m = 1; m < N; ++m) {
      sum.value += (a[m] * s + b[m] * (T(1) - c)) / T(m);
      sum.slope += a[m] * c + b[m] * s;
      const T next = cos_phi * c - sin_phi * s;
      s = cos_phi * s + sin_phi * c;
      c = next;
    }
    return sum;
  }

  Sh<N, T> f_{};          // of integral 1
  Zh<N + 1, T> below_{};  // of the integral from -1 to z, as a zonal function
  bool is_uniform_ = false;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
