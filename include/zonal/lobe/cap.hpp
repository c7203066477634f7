// The spherical cap: what a sphere of constant radiance looks like from outside.
//
// z_l = sqrt(pi (2l+1)) * integral of P_l(u) from cos a to 1. The papers' form of it, P_(l-1) - P_(l+1) at cos a
// [1, Eq. 14], loses everything for small caps (7 % in float at a = 1e-3). The identity
// (1-x^2) P_l'(x) = l(l+1)/(2l+1) (P_(l-1)(x) - P_(l+1)(x)) gives, with P_l' = l(l+1)/2 e_l and t = 1 - cos a,
//
//   z_l = sqrt(pi (2l+1)) / 2 sin^2 a e_l,   e_1 = 1,   e_l = e_(l-1) + d_l,
//   d_1 = 0,   d_l = ((l-2) d_(l-1) - (2l-1) t e_(l-1)) / (l+1)                  (basis/difference_step.hpp, m = 1)
//
// where nothing cancels. Beyond the hemisphere z_l(pi - a) = (-1)^(l+1) z_l(a) for l >= 1.
//
// The derivative is the integrand at the edge, dz_l/da = sqrt(pi (2l+1)) sin a P_l(cos a), without the division by
// sin^2 a of [2, Eq. 14-16]; P_l too by its differences, m = 0.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
// [2] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <cassert>
#include <cmath>
#include <type_traits>

#include "../basis/difference_step.hpp"
#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A cap of half angle a about the z axis, 0 <= a <= pi, kept by cosine and sine (sine >= 0).
template <class T>
struct SphericalCap {
  static_assert(!std::is_integral_v<T>, "a cap of integers: write 3.0f");
  T cos_angle, sin_angle;

  /// From the half angle in radians.
  ZONAL_DEVICE static SphericalCap from_angle(T angle) {
    using std::cos, std::sin;
    return {cos(angle), sin(angle)};
  }

  /// The cap that a sphere covers: sin a = radius / distance, distance measured to its centre. From within the sphere
  /// (distance < radius) it is the hemisphere, which is continuous at the surface. distance > 0, radius >= 0.
  ZONAL_INLINE static constexpr SphericalCap from_sphere(const T& distance, const T& radius) {
    return from_sphere(distance, T(1) / distance, radius);
  }
  /// The same where the distance's reciprocal is at hand.
  ZONAL_INLINE static constexpr SphericalCap from_sphere(const T& distance, const T& inverse_distance,
                                                         const T& radius) {
    // Just above the surface 1 - sin a has lost what distance - radius still has.
    const T height = maximum(distance - radius, T(0)) * inverse_distance;
    const T sin_angle = minimum(radius * inverse_distance, T(1));
    return {sqrt(height * (T(1) + sin_angle)), sin_angle};
  }
};

namespace detail {
// 1 - |cos a|, from the sine where the cosine is near 1.
template <class T>
ZONAL_INLINE constexpr T versine(const SphericalCap<T>& cap) {
  const T cosine = abs(cap.cos_angle);
  return select(cosine < T(0.5L), T(1) - cosine, cap.sin_angle * cap.sin_angle / (T(1) + cosine));
}
}  // namespace detail

namespace detail {
// d_l from e_(l-1) and d_(l-1).
template <int l, class T>
ZONAL_INLINE constexpr T cap_step(const T& t, const T& e, const T& d) {
  if constexpr (l < 2) {
    return T(0);
  } else if constexpr (l == 2) {
    return -(t * e);
  } else {
    constexpr auto of_step = rounded<T>(difference_of_step(l, 1)), of_sum = rounded<T>(difference_of_sum(l, 1));
    return next_difference(T(of_step), T(of_sum), t, e, d);
  }
}

// All times sin^2 a: e_l and d_l. For a cap narrow against the bands e_l stays near its first value, and adding each
// small d_l to it would round them away; so the d_l are summed apart. For a wide one e_l itself becomes small, and is
// summed.
constexpr long double narrow_cap_cosine(int bands) { return 1 - 6.0L / (bands * bands); }

template <class T>
struct CapSums {
  mask_t<T> is_small;
  T cosine, sin2, t;  // t = 1 - |cos a|
  T zeroth;           // 2 (1 - cos a)
  T apart, e, d, sum;
  T even_sign;  // a cap and its complement differ in the even degrees

  ZONAL_INLINE constexpr CapSums(const SphericalCap<T>& cap, const T& narrow)
      : is_small(T(0) < cap.cos_angle),
        cosine(abs(cap.cos_angle)),
        sin2(cap.sin_angle * cap.sin_angle),
        t(versine(cap)),
        zeroth(T(2) * select(is_small, t, T(1) + cosine)),
        apart(select(narrow < cosine, sin2, T(0))),
        e(sin2),
        d(T(0)),
        sum(sin2 - apart),
        even_sign(select(is_small, T(1), T(-1))) {}
  // d_l, from which e_l follows.
  ZONAL_INLINE constexpr void add(const T& next) {
    d = next;
    sum = sum + d;
    e = apart + sum;
  }
};

// z_l without its constant, 2 z_l / sqrt(pi (2l+1)), to sink(l, value): sin^2 a e_l, and 2 (1 - cos a) for l = 0.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void cap_sums(const SphericalCap<T>& cap, Sink&& sink) {
  constexpr auto narrow = rounded<T>(narrow_cap_cosine(N));
  CapSums<T> sums(cap, T(narrow));
  sink(Index<0>{}, sums.zeroth);
  unroll<1, N>([&](auto l) ZONAL_INLINE {
    if constexpr (l > 1) sums.add(cap_step<l>(sums.t, sums.e, sums.d));
    if constexpr (l % 2 == 1) {
      sink(l, sums.e);
    } else {
      sink(l, sums.even_sign * sums.e);
    }
  });
}

// The same for cos a >= 0, without a choice: e_l itself is summed.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void hemisphere_cap_sums(const SphericalCap<T>& cap, Sink&& sink) {
  const T sin2 = cap.sin_angle * cap.sin_angle;
  const T t = sin2 / (T(1) + cap.cos_angle);
  sink(Index<0>{}, t + t);
  T e = sin2, d = T(0);
  unroll<1, N>([&](auto l) ZONAL_INLINE {
    d = cap_step<l>(t, e, d);
    if constexpr (l > 1) e = e + d;
    sink(l, e);
  });
}

// P_l(cos a) to sink(l, value).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void cap_legendre(const SphericalCap<T>& cap, Sink&& sink) {
  const T t = versine(cap);
  const T odd_sign = select(cap.cos_angle < T(0), T(-1), T(1));  // P_l(-x) = (-1)^l P_l(x)
  T legendre = T(1), step = T(0);
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    if constexpr (l == 1) step = -t;
    if constexpr (l > 1) {
      constexpr auto of_step = rounded<T>(difference_of_step(l, 0)), of_sum = rounded<T>(difference_of_sum(l, 0));
      step = next_difference(T(of_step), T(of_sum), t, legendre, step);
    }
    if constexpr (l > 0) legendre = legendre + step;
    if constexpr (l % 2 == 1) {
      sink(l, odd_sign * legendre);
    } else {
      sink(l, legendre);
    }
  });
}
}  // namespace detail

/// The zonal coefficients of the cap's indicator (1 inside, 0 outside) to sink(l, value).
/// Greatest error against the largest coefficient, at every angle: docs/accuracy.md.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project(const SphericalCap<T>& cap, Sink&& sink) {
  detail::cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE {
    constexpr auto scale = rounded<T>(detail::zonal_integral<l> / 2);
    sink(l, T(scale) * sum);
  });
}

/// The same for a cap up to the hemisphere, such as a sphere covers, with no choices; for many bands a little less
/// accurate: docs/accuracy.md.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project_up_to_hemisphere(const SphericalCap<T>& cap, Sink&& sink) {
  detail::hemisphere_cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE {
    constexpr auto scale = rounded<T>(detail::zonal_integral<l> / 2);
    sink(l, T(scale) * sum);
  });
}

/// The same as an array.
template <int N, class T>
constexpr Zh<N, T> project(const SphericalCap<T>& cap) {
  Zh<N, T> zh{};
  project<N>(cap, [&](auto l, const T& value) ZONAL_INLINE { zh.values[l] = value; });
  return zh;
}

/// dz_l/da, per radian, to sink(l, value). Greatest error against the largest of them: docs/accuracy.md.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project_derivative(const SphericalCap<T>& cap, Sink&& sink) {
  detail::cap_legendre<N>(cap, [&](auto l, const T& legendre) ZONAL_INLINE {
    constexpr auto scale = rounded<T>(detail::zonal_integral<l>);
    sink(l, T(scale) * (cap.sin_angle * legendre));
  });
}

/// The same as an array.
template <int N, class T>
constexpr Zh<N, T> project_derivative(const SphericalCap<T>& cap) {
  Zh<N, T> zh{};
  project_derivative<N>(cap, [&](auto l, const T& value) ZONAL_INLINE { zh.values[l] = value; });
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
