// The gradient of the basis by angles, as in [1]: the slow reference. Undefined at the poles, for it divides by sin
// theta. evaluate_with_gradient (gradient.hpp) needs no angles.
//
// Both methods give the derivatives by theta and phi; by phi it is -m Y_l^-m [1, Eq. 17]. to_cartesian is Eq. 23.
//
// - sloan_like: with Y_l^m = Q_l^m U_m, Q a polynomial in z and U_m = Re (x+iy)^m,
//   d/dtheta Y = (Q m cos/sin + T) U, T = dQ/dtheta by the derivative of Q's recurrence     [1] Eq. 20-22, 32, 33
// - direct: d/dtheta P_l^m = -((l-m+1)(l+m) P_l^(m-1) - P_l^(m+1)) / 2, P_l^1 at m = 0                  [1] Eq. 18, 19
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include "gradient.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace reference {

/// Values, and derivatives by theta and phi.
template <int N, class T>
struct AngularGradient {
  Sh<N, T> value, by_theta, by_phi;
};

namespace detail {
using zonal::detail::legendre_column;

// sink(l, Q_l^m, T_l^m), normalised, for l = m .. N-1: the first four explicitly, then the recurrence and its
// derivative.
template <int N, int m, class T, class Sink>
ZONAL_INLINE constexpr void legendre_column_with_slope(const T& cosine, const T& sine, Sink&& sink) {
  const T cosine2 = cosine * cosine, sine_cosine = sine * cosine;
  T before = T(0), last = T(0), slope_before = T(0), slope_last = T(0);
  legendre_column<N, m>(cosine, cosine2, [&](auto l, const T& q) ZONAL_INLINE {
    T slope = T(0);
    if constexpr (l == m + 1) {
      constexpr auto linear = rounded<T>(basis_table<N>.linear[m]);
      slope = -(T(linear) * sine);
    } else if constexpr (l == m + 2) {
      constexpr auto square = rounded<T>(-2 * basis_table<N>.square[m][1]);
      slope = T(square) * sine_cosine;
    } else if constexpr (l == m + 3) {
      constexpr auto cube = rounded<T>(3 * basis_table<N>.cube[m][1]), linear = rounded<T>(basis_table<N>.cube[m][0]);
      slope = -sine * (T(cube) * cosine2 + T(linear));
    } else if constexpr (l > m + 3) {
      constexpr auto raise = rounded<T>(basis_table<N>.raise[l][m]), lower = rounded<T>(basis_table<N>.lower[l][m]);
      slope = T(raise) * (cosine * slope_last - sine * last) - T(lower) * slope_before;
    }
    sink(l, q, slope);
    before = last, last = q;
    slope_before = slope_last, slope_last = slope;
  });
}
}  // namespace detail

/// By the recurrences of [1, Eq. 22], at a unit vector that is not a pole.
template <int N, class Direction>
ZONAL_INLINE inline AngularGradient<N, component_t<Direction>> angular_gradient_sloan_like(const Direction& direction) {
  using T = component_t<Direction>;
  const auto v = zonal::detail::as_direction<T>(direction);
  const T x = v.x, y = v.y, z = v.z;
  const T sine = sqrt(x * x + y * y), cotangent = z / sine;
  AngularGradient<N, T> result;
  T c = T(1), s = T(0);  // Re and Im of (x + iy)^m
  unroll<0, N>([&](auto m) ZONAL_INLINE {
    const T m_cotangent = T(int{m}) * cotangent;
    detail::legendre_column_with_slope<N, m>(z, sine, [&](auto l, const T& q, const T& slope) ZONAL_INLINE {
      const int cosine_index = sh_index(l, m), sine_index = sh_index(l, -m);
      const T by_theta = m == 0 ? slope : q * m_cotangent + slope;
      result.value.values[cosine_index] = q * c;
      result.by_theta.values[cosine_index] = by_theta * c;
      if constexpr (m == 0) {
        result.by_phi.values[cosine_index] = T(0);
      } else {
        result.value.values[sine_index] = q * s;
        result.by_theta.values[sine_index] = by_theta * s;
        result.by_phi.values[cosine_index] = T(-m) * result.value.values[sine_index];
        result.by_phi.values[sine_index] = T(int{m}) * result.value.values[cosine_index];
      }
    });
    const T next = x * c - y * s;
    s = x * s + y * c;
    c = next;
  });
  return result;
}

/// By the derivatives of the associated Legendre functions [1, Eq. 19], at a unit vector that is not a pole.
template <int N, class Direction>
ZONAL_INLINE inline AngularGradient<N, component_t<Direction>> angular_gradient_direct(const Direction& direction) {
  using T = component_t<Direction>;
  const auto v = zonal::detail::as_direction<T>(direction);
  const T x = v.x, y = v.y, z = v.z;
  const T sine = sqrt(x * x + y * y), cos_phi = x / sine, sin_phi = y / sine;

  // Normalised P_l^m = Q_l^m sin^m, all of them first: the derivative needs the orders m-1 and m+1.
  T legendre[static_cast<std::size_t>(N)][static_cast<std::size_t>(N)] = {};
  T power = T(1);
  unroll<0, N>([&](auto m) ZONAL_INLINE {
    detail::legendre_column<N, m>(z, z * z, [&](auto l, const T& q) ZONAL_INLINE { legendre[l][m] = q * power; });
    power = power * sine;
  });

  AngularGradient<N, T> result;
  T c = T(1), s = T(0);  // cos and sin of m phi
  unroll<0, N>([&](auto m) ZONAL_INLINE {
    unroll<m, N>([&](auto l) ZONAL_INLINE {
      // The factors of Eq. 19 with the normalisation folded in: sqrt((l-m+1)(l+m)) / 2 downwards, and upwards; at m = 0
      // and from m = 1 down to 0 the sqrt(2) that Y_l^0 lacks. The sign is that of the Condon-Shortley phase.
      constexpr long double up = constexpr_sqrt((l - m) * (l + m + 1.0L)) * (m == 0 ? constexpr_sqrt(0.5L) : 0.5L);
      constexpr long double down = constexpr_sqrt((l - m + 1.0L) * (l + m)) * (m == 1 ? constexpr_sqrt(0.5L) : 0.5L);
      T by_theta = T(0);
      if constexpr (m < l) by_theta = T(up) * legendre[l][m + 1];
      if constexpr (m > 0) by_theta = by_theta - T(down) * legendre[l][m - 1];
      const int cosine_index = sh_index(l, m), sine_index = sh_index(l, -m);
      result.value.values[cosine_index] = legendre[l][m] * c;
      result.by_theta.values[cosine_index] = by_theta * c;
      if constexpr (m == 0) {
        result.by_phi.values[cosine_index] = T(0);
      } else {
        result.value.values[sine_index] = legendre[l][m] * s;
        result.by_theta.values[sine_index] = by_theta * s;
        result.by_phi.values[cosine_index] = T(-m) * result.value.values[sine_index];
        result.by_phi.values[sine_index] = T(int{m}) * result.value.values[cosine_index];
      }
    });
    const T next = cos_phi * c - sin_phi * s;
    s = cos_phi * s + sin_phi * c;
    c = next;
  });
  return result;
}

/// From derivatives by angles to derivatives by x, y, z at the same unit vector [1, Eq. 23].
template <int N, class T, class Direction>
ZONAL_INLINE inline ShGradient<N, T> to_cartesian(const AngularGradient<N, T>& angular, const Direction& direction) {
  const auto v = zonal::detail::as_direction<T>(direction);
  const T x = v.x, y = v.y, z = v.z;
  const T sine2 = x * x + y * y, sine = sqrt(sine2), z_by_sine = z / sine, inverse = T(1) / sine2;
  const T x_theta = x * z_by_sine, y_theta = y * z_by_sine, x_phi = -(y * inverse), y_phi = x * inverse;
  ShGradient<N, T> result;
  result.value = angular.value;
  for (int i = 0; i < N * N; ++i) {
    result.gradient[0].values[i] = x_theta * angular.by_theta.values[i] + x_phi * angular.by_phi.values[i];
    result.gradient[1].values[i] = y_theta * angular.by_theta.values[i] + y_phi * angular.by_phi.values[i];
    result.gradient[2].values[i] = -sine * angular.by_theta.values[i];
  }
  return result;
}

}  // namespace reference
}  // namespace ZONAL_TARGET
}  // namespace zonal
