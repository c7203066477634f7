// A function's value in a direction of any length, and the derivatives of a loss by its coefficients and by the
// direction: what fitting takes, of light probes or of the colours of splats. Forward and backward in one, without a
// tape.
//
// With a_i the derivative of the loss by Y_i, the sum of coefficient i times the derivative by the value over channels,
// a coefficient's is Y_i times that by the value; and the direction's is the gradient of sum_i a_i Y_i. In the notation
// of basis/table.hpp, with c_m + i s_m = (x + iy)^m, C_m = sum_l a_l^m q_l^m and S_m = sum_l a_l^-m q_l^m, that sum is
// sum_m (C_m c_m + S_m s_m), and
//
//   d/dx = sum_m m (C_m c_(m-1) + S_m s_(m-1))    d/dy = sum_m m (S_m c_(m-1) - C_m s_(m-1))
//   d/dz = sum_m (C'_m c_m + S'_m s_m)            by (q_l^m)' = k_l^m q_l^(m+1)
//
// for q_l^m is, up to a factor, the m-th derivative of a polynomial. So the gradient of the basis is never formed: two
// thirds of the operations of evaluate_with_gradient and a dot, and fewer than the reverse sweep of the record takes
// (scalar/adjoint.hpp). What it has along the direction is without meaning; the way through v / |v| leaves that out.
//
// [1] Kerbl et al., "3D Gaussian Splatting for Real-Time Radiance Field Rendering", ACM TOG 42(4), 2023.
#pragma once

#include <cstddef>
#include <type_traits>

#include "dot.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// k_l^m. Orders above 0 have a factor sqrt(2), and their signs alternate.
constexpr long double column_slope(int l, int m) {
  return -constexpr_sqrt((l - m) * (l + m + 1.0L) / (m == 0 ? 2 : 1));
}

// What the basis at a unit vector is a product of.
template <int N, class T>
struct BasisFactors {
  static constexpr std::size_t size = N;
  EvenSh<N, T> q;      // q_l^m
  T c[size], s[size];  // Re and Im of (x + iy)^m

  ZONAL_DEVICE ZONAL_INLINE constexpr BasisFactors(const T& x, const T& y, const T& z) {
    const T z2 = z * z;
    c[0] = T(1), s[0] = T(0);
    if constexpr (N > 1) c[1] = x, s[1] = y;
    unroll<0, N>([&](auto m) ZONAL_INLINE {
      legendre_column<N, m>(z, z2, [&](auto l, const T& value) ZONAL_INLINE { q.values[even_index(l, m)] = value; });
      if constexpr (m > 1) {
        c[m] = c[m - 1], s[m] = s[m - 1];
        turn(x, y, c[m], s[m]);
      }
    });
  }

  // sink(l, m, Y_l^m), in the order of evaluate.
  template <class Sink>
  ZONAL_INLINE constexpr void evaluate(Sink&& sink) const {
    unroll<0, N>([&](auto m) ZONAL_INLINE {
      unroll<m, N>([&](auto l) ZONAL_INLINE {
        const T& factor = q.values[even_index(l, m)];
        if constexpr (m == 0) {
          sink(l, m, factor);
        } else {
          sink(l, Index<-m>{}, factor * s[m]);
          sink(l, m, factor * c[m]);
        }
      });
    });
  }
};

// The sums of factor(l) a_l^m and of factor(l) a_l^-m over l = first .. N-1.
template <int first, int m, int N, class T>
struct ColumnSums {
  T c, s;

  template <class Factor>
  ZONAL_DEVICE ZONAL_INLINE constexpr ColumnSums(const Sh<N, T>& a, Factor factor) {
    unroll<first, N>([&](auto l) ZONAL_INLINE {
      const T by = factor(l);
      const T &a_c = a.values[sh_index(l, m)], &a_s = a.values[sh_index(l, -m)];
      if constexpr (l == first) {
        c = by * a_c, s = by * a_s;
      } else {
        add_product(c, by, a_c), add_product(s, by, a_s);
      }
    });
  }
};

// The gradient of the sum of a_i Y_i at a unit vector, but for a part along it. a_0 is not read.
template <int N, class T>
ZONAL_DEVICE ZONAL_INLINE constexpr void gradient_of_sum(const BasisFactors<N, T>& at, const Sh<N, T>& a,
                                                         T (&gradient)[3]) {
  for (T& component : gradient) component = T(0);
  unroll<0, N>([&](auto m) ZONAL_INLINE {
    if constexpr (m + 1 < N) {
      const ColumnSums<m + 1, m, N, T> slope(a, [&](auto l) ZONAL_INLINE {
        constexpr auto k = rounded<T>(column_slope(l, m));
        return T(k) * at.q.values[even_index(l, m + 1)];
      });
      if constexpr (m == 0) {
        gradient[2] = slope.c;
      } else {
        gradient[2] = gradient[2] + (slope.c * at.c[m] + slope.s * at.s[m]);
      }
    }
    if constexpr (m == 1) {
      const ColumnSums<1, 1, N, T> sum(a, [&](auto l) ZONAL_INLINE { return at.q.values[even_index(l, 1)]; });
      gradient[0] = sum.c, gradient[1] = sum.s;
    } else if constexpr (m > 1) {
      const ColumnSums<m, m, N, T> sum(a,
                                       [&](auto l) ZONAL_INLINE { return T(int{m}) * at.q.values[even_index(l, m)]; });
      gradient[0] = gradient[0] + (sum.c * at.c[m - 1] + sum.s * at.s[m - 1]);
      gradient[1] = gradient[1] + (sum.s * at.c[m - 1] - sum.c * at.s[m - 1]);
    }
  });
}

}  // namespace detail

/// What is made of a function's value. `plain`: nothing. `splat`: a splat's colour, as 3D Gaussian splatting has it
/// [1], half more and at least 0; where it would be less than 0, its derivatives are 0.
enum class ColourRule { plain, splat };

namespace detail {

// The numbers of a colour; a number is its own.
template <class C>
inline constexpr int channels_v = static_cast<int>(sizeof(C) / sizeof(number_t<C>));
template <class C>
ZONAL_INLINE constexpr auto& channel_of(C& colour, [[maybe_unused]] int channel) {
  if constexpr (is_colour_v<std::remove_const_t<C>>) {
    return colour[channel];
  } else {
    return colour;
  }
}

// Of one channel: the value, and the loss's derivative by the sum that it is made of.
template <ColourRule rule, class T>
ZONAL_INLINE constexpr T apply_rule(const T& sum) {
  if constexpr (rule == ColourRule::plain) return sum;
  return maximum(T(sum + T(0.5L)), T(0));
}
template <ColourRule rule, class T>
ZONAL_INLINE constexpr T adjoint_of_rule(const T& sum, const T& by_value) {
  if constexpr (rule == ColourRule::plain) return by_value;
  return select(T(sum + T(0.5L)) < T(0), T(0), by_value);
}

// The kernel, of any number of channels: reads coefficient(Index<i>, Index<channel>), and hands over the derivatives by
// them, by_coefficient(Index<i>, Index<channel>, value).
template <int N, ColourRule rule, int channels, class T, class Coefficient, class Sink>
ZONAL_DEVICE ZONAL_INLINE constexpr void reconstruct_with_adjoint(const T (&direction)[3], Coefficient&& coefficient,
                                                                  const T (&by_value)[std::size_t{channels}],
                                                                  T (&value)[std::size_t{channels}],
                                                                  T (&by_direction)[3], Sink&& by_coefficient) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  const UnitVector3<T> unit(direction[0], direction[1], direction[2]);
  const BasisFactors<N, T> factors(unit.x, unit.y, unit.z);
  Sh<N, T> basis;
  Accumulator<N * N, T> total[std::size_t{channels}];
  factors.evaluate([&](auto l, auto m, const T& y) ZONAL_INLINE {
    constexpr Index<sh_index(l, m)> i;
    basis.values[i] = y;
    unroll<0, channels>([&](auto c) ZONAL_INLINE { total[c].add(i, coefficient(i, c) * y); });
  });

  T by_sum[std::size_t{channels}];
  unroll<0, channels>([&](auto c) ZONAL_INLINE {
    const T sum = total[c].sum();
    value[c] = apply_rule<rule>(sum);
    by_sum[c] = adjoint_of_rule<rule>(sum, by_value[c]);
  });

  Sh<N, T> by_basis;
  unroll<0, N * N>([&](auto i) ZONAL_INLINE {
    by_basis.values[i] = by_sum[0] * coefficient(i, Index<0>{});
    unroll<1, channels>([&](auto c) ZONAL_INLINE { add_product(by_basis.values[i], by_sum[c], coefficient(i, c)); });
    unroll<0, channels>([&](auto c) ZONAL_INLINE { by_coefficient(i, c, by_sum[c] * basis.values[i]); });
  });

  T gradient[3];
  gradient_of_sum(factors, by_basis, gradient);
  const T along = gradient[0] * unit.x + gradient[1] * unit.y + gradient[2] * unit.z;
  by_direction[0] = (gradient[0] - unit.x * along) * unit.inverse_length;
  by_direction[1] = (gradient[1] - unit.y * along) * unit.inverse_length;
  by_direction[2] = (gradient[2] - unit.z * along) * unit.inverse_length;
}

}  // namespace detail

/// The function's value in a direction of any length, from a camera to a splat, say: 1e-18 to 1e18 in float, for the
/// sake of its square. One of length 0 gives NaN. C is a number or a colour with c[i].
template <ColourRule rule = ColourRule::plain, int N, class C, class Direction>
ZONAL_DEVICE constexpr C reconstruct_along(const Sh<N, C>& sh, const Direction& direction) {
  using T = component_t<Direction>;
  const auto v = detail::as_direction<T>(direction);
  C value = reconstruct(sh, detail::UnitVector3<T>(v.x, v.y, v.z));
  for (int c = 0; c < detail::channels_v<C>; ++c) {
    auto& number = detail::channel_of(value, c);
    number = detail::apply_rule<rule>(number);
  }
  return value;
}

/// A value, and the derivatives of a loss by what it is made of: N*N of the coefficients' type, and three numbers,
/// which are across the direction, and inversely as its length. By the camera's position they are the negative.
template <int N, class C, class T>
struct ReconstructionAdjoint {
  C value;
  Sh<N, C> by_sh;
  T by_direction[3];
};

/// reconstruct_along and, given the loss's derivatives by its value, those by coefficients and direction. C is a
/// number, or a colour that is an array of numbers in memory, with c[i]: glm::vec3, Eigen::Vector3f, a struct of three
/// floats. Any scalar, packets too.
template <ColourRule rule = ColourRule::plain, int N, class C, class Direction>
ZONAL_DEVICE constexpr ReconstructionAdjoint<N, C, component_t<Direction>> reconstruct_with_adjoint(
    const Sh<N, C>& sh, const Direction& direction, const C& by_value) {
  using T = component_t<Direction>;
  static_assert(sizeof(C) % sizeof(T) == 0 && std::is_same_v<detail::number_t<C>, T>, "a T, or some of them");
  constexpr int channels = detail::channels_v<C>;
  const auto v = detail::as_direction<T>(direction);
  T by[std::size_t{channels}], value[std::size_t{channels}];
  for (int c = 0; c < channels; ++c) by[c] = detail::channel_of(by_value, c);
  ReconstructionAdjoint<N, C, T> result;
  detail::reconstruct_with_adjoint<N, rule, channels, T>(
      {v.x, v.y, v.z}, [&](auto i, auto c) ZONAL_INLINE { return detail::channel_of(sh.values[i], c); }, by, value,
      result.by_direction,
      [&](auto i, auto c, const T& number) ZONAL_INLINE { detail::channel_of(result.by_sh.values[i], c) = number; });
  for (int c = 0; c < channels; ++c) detail::channel_of(result.value, c) = value[c];
  return result;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
