// The real spherical harmonics at a direction, for any number of bands.
//
// Each function comes in two forms. The sink form hands over every value as soon as it is known,
// sink(l, m, value) with l and m constant expressions, and stores nothing; the array form is the sink that fills
// an array. Conventions: zonal.hpp. Formulas and constants: table.hpp.
//
// Greatest error, in units of the largest value of the degree, over all directions, poles included:
// docs/accuracy.md, from the table that also drives the test.
#pragma once

#include <cassert>

#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"
#include "../scalar/vector3.hpp"
#include "order_lanes.hpp"
#include "sh.hpp"
#include "table.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// q_l^m(z) for l = m .. N-1, handed to sink(l, q). See table.hpp.
template <int N, int m, class T, class Sink>
ZONAL_INLINE constexpr void legendre_column(const T& z, const T& z2, Sink&& sink) {
  static_assert(!std::is_integral_v<T>, "a direction of integers: it has to be of floating-point numbers");
  constexpr auto diagonal = rounded<T>(basis_table<N>.diagonal[m]);
  sink(Index<m>{}, T(diagonal));
  T below = T(0), last = T(0);
  if constexpr (m + 1 < N) {
    constexpr auto linear = rounded<T>(basis_table<N>.linear[m]);
    sink(Index<m + 1>{}, T(linear) * z);
  }
  if constexpr (m + 2 < N) {
    constexpr auto square = rounded<T>(basis_table<N>.square[m][1]), constant = rounded<T>(basis_table<N>.square[m][0]);
    below = T(square) * z2 + T(constant);
    sink(Index<m + 2>{}, below);
  }
  if constexpr (m + 3 < N) {
    constexpr auto cube = rounded<T>(basis_table<N>.cube[m][1]), linear = rounded<T>(basis_table<N>.cube[m][0]);
    last = z * (T(cube) * z2 + T(linear));
    sink(Index<m + 3>{}, last);
  }
  unroll<m + 4, N>([&](auto l) ZONAL_INLINE {
    constexpr auto raise = rounded<T>(basis_table<N>.raise[l][m]), lower = rounded<T>(basis_table<N>.lower[l][m]);
    const T next = next_legendre(T(raise), T(lower), z, last, below);
    below = last;
    last = next;
    sink(l, next);
  });
}

// A direction far from unit length is a mistake of the caller; a rounded one is not. For assertions.
template <class T>
constexpr bool is_unit(const T& x, const T& y, const T& z) {
  if constexpr (is_builtin_scalar_v<T>) {
    return abs(x * x + y * y + z * z - T(1)) < T(1e-3L);
  } else {
    return true;
  }
}
// The same for the part of one in a plane, or along an axis.
template <class T>
constexpr bool is_part_of_unit(const T& x, const T& z) {
  if constexpr (is_builtin_scalar_v<T>) {
    return x * x + z * z - T(1) < T(1e-3L);
  } else {
    return true;
  }
}

}  // namespace detail

/// Y_l^m(x, y, z) for all l < N, |m| <= l, to sink(l, m, value). (x, y, z) is a unit vector.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void evaluate(const T& x, const T& y, const T& z, Sink&& sink) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  assert(detail::is_unit<T>(x, y, z));
  const T z2 = z * z;
  detail::legendre_column<N, 0>(z, z2, [&](auto l, const T& q) ZONAL_INLINE { sink(l, Index<0>{}, q); });

  T c = x, s = y;  // Re and Im of (x + iy)^m
  unroll<1, N>([&](auto m) ZONAL_INLINE {
    detail::legendre_column<N, m>(z, z2, [&](auto l, const T& q) ZONAL_INLINE {
      sink(l, Index<-m>{}, q * s);
      sink(l, m, q * c);
    });
    if constexpr (m + 1 < N) detail::turn(x, y, c, s);
  });
}

/// The m >= 0 half of the same, which needs x and z only: y enters through x^2 + y^2 = 1 - z^2.
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void evaluate_even(const T& x, const T& z, Sink&& sink) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  assert(detail::is_part_of_unit<T>(x, z));
  const T z2 = z * z;
  detail::legendre_column<N, 0>(z, z2, [&](auto l, const T& q) ZONAL_INLINE { sink(l, Index<0>{}, q); });

  // Re (x+iy)^(m+1) = 2x Re (x+iy)^m - (x^2+y^2) Re (x+iy)^(m-1): the sine twin is not needed.
  const T x_twice = x + x, sin2 = T(1) - z2;
  T before = T(1), c = x;
  unroll<1, N>([&](auto m) ZONAL_INLINE {
    detail::legendre_column<N, m>(z, z2, [&](auto l, const T& q) ZONAL_INLINE { sink(l, m, q * c); });
    if constexpr (m + 1 < N) {
      const T next = x_twice * c - sin2 * before;
      before = c;
      c = next;
    }
  });
}

/// Y_l^0 at cos_angle from the axis, -1 to 1, to sink(l, value).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void evaluate_zonal(const T& cos_angle, Sink&& sink) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  assert(detail::is_part_of_unit<T>(cos_angle, T(0)));
  detail::legendre_column<N, 0>(cos_angle, cos_angle * cos_angle, sink);
}

// The arrays below are not set to zero first: that would double the stores, and with packets these are what limits.
// Hence the array forms can be computed at compile time from C++20 on only.

namespace detail {
// evaluate, kept as an array, inside a kernel.
template <int N, class T>
ZONAL_INLINE constexpr void evaluate_into(Sh<N, T>& sh, const T& x, const T& y, const T& z) {
  evaluate<N>(x, y, z, [&](auto l, auto m, const T& value) ZONAL_INLINE { sh.values[sh_index(l, m)] = value; });
}
}  // namespace detail

/// N*N values in the order l(l+1)+m at a unit vector: anything with v[0], v[1], v[2], or v.x, v.y, v.z. Floats and
/// doubles of many bands differ by roundings from what the sink form gives: order_lanes.hpp.
template <int N, class Direction>
ZONAL_DEVICE constexpr Sh<N, component_t<Direction>> evaluate(const Direction& direction) {
  using T = component_t<Direction>;
  static_assert(N >= 1, "bands out of range: N >= 1");
  Sh<N, T> sh;
  const auto v = detail::as_direction<T>(direction);
#if defined(ZONAL_ORDERS_IN_LANES)
  if constexpr (detail::are_orders_in_lanes<N, T>) {
    if (!__builtin_is_constant_evaluated()) {
      assert(detail::is_unit<T>(v.x, v.y, v.z));
      detail::evaluate_orders<N>(sh, v.x, v.y, v.z);
      return sh;
    }
  }
#endif
  detail::evaluate_into(sh, v.x, v.y, v.z);
  return sh;
}

/// N(N+1)/2 values in the order l(l+1)/2+m, from the x and z of a unit vector.
template <int N, class T>
ZONAL_DEVICE constexpr EvenSh<N, T> evaluate_even(const T& x, const T& z) {
  EvenSh<N, T> sh;
  evaluate_even<N>(x, z, [&](auto l, auto m, const T& value) ZONAL_INLINE { sh.values[even_index(l, m)] = value; });
  return sh;
}

/// The N values Y_l^0.
template <int N, class T>
ZONAL_DEVICE constexpr Zh<N, T> evaluate_zonal(const T& cos_angle) {
  Zh<N, T> zh;
  evaluate_zonal<N>(cos_angle, [&](auto l, const T& value) ZONAL_INLINE { zh.values[l] = value; });
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
