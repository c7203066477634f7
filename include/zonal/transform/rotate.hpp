// Rotations of a function on the sphere, and reflections: (R f)(d) = f(R^-1 d). The function turns with its lobes, an
// axis a of it going to R a, and evaluate(R d) = R evaluate(d).
//
// About z an order is only mixed with its opposite: with cos(m a) and sin(m a) that is 4 multiplications a pair. Any
// rotation is three of these, with y and z exchanged before and after the second, which makes it one about y [1]:
//
//   R = Rz(a) Ry(b) Rz(c) = Z(a) S Z(-b) S Z(c)
//
// S has few entries that are not zero, and they are constants (swap_matrix.hpp): at 5 bands all takes 208
// multiplications for 164 of dense blocks, which have to be computed first; at 10 bands 1218 for 1329.
//
// The cosines and sines of a, b and c follow from the matrix without trigonometry: b's and c's from the third row, and
// a's from what then is left of the second column, which is of unit length whatever b is; so nothing is lost where b is
// next to 0 or pi.
//
// [1] D. Pinchon, P. E. Hoggan, "Rotation matrices for real spherical harmonics", Journal of Physics A 40, 2007.
#pragma once

#include <cmath>
#include <limits>

#include "../basis/sh.hpp"
#include "../scalar/lanes.hpp"
#include "../scalar/vector3.hpp"
#include "swap_matrix.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

template <class T>
struct CosineAndSine {
  T cosine, sine;
};

/// 1 / sqrt(length2); of what is so small that it is no normal number, 0.
template <class T>
ZONAL_INLINE constexpr T inverse_length(const T& length2) {
  constexpr auto smallest = (std::numeric_limits<lane_t<T>>::min)();
  const auto is_there = T(smallest) < length2;
  return select(is_there, T(1) / sqrt(select(is_there, length2, T(1))), T(0));
}

}  // namespace detail

/// A turn about z, prepared for N bands: at m, 0 <= m < N, the cosine and sine of m times the angle.
template <int N, class T>
struct TurnAboutZ {
  T cosine[static_cast<std::size_t>(N)], sine[static_cast<std::size_t>(N)];

  /// By the angle's cosine and sine, from x towards y.
  ZONAL_INLINE constexpr TurnAboutZ(const T& cos_angle, const T& sin_angle) : cosine{T(1)}, sine{T(0)} {
    unroll<1, N>([&](auto m) ZONAL_INLINE {
      if constexpr (m == 1) {
        cosine[1] = cos_angle, sine[1] = sin_angle;
      } else {
        // A shorter chain than one by one. The errors grow as m; by Chebyshev's recurrence, as m^2.
        constexpr int half = m / 2, rest = m - half;
        cosine[m] = cosine[half] * cosine[rest] - sine[half] * sine[rest];
        sine[m] = sine[half] * cosine[rest] + cosine[half] * sine[rest];
      }
    });
  }
  constexpr TurnAboutZ inverse() const {
    TurnAboutZ turn = *this;
    for (T& s : turn.sine) s = -s;
    return turn;
  }
};

namespace detail {

// An order and its opposite, turned by m times an angle.
template <class Number, class C>
ZONAL_INLINE constexpr void turn_pair(const Number& cosine, const Number& sine, const C& even, const C& odd, C& to_even,
                                      C& to_odd) {
  C turned_even = times(cosine, even), turned_odd = times(cosine, odd);
  subtract_times(turned_even, sine, odd);
  add_times(turned_odd, sine, even);
  to_even = turned_even;
  to_odd = turned_odd;
}

/// Degree l of a function turned about z: out[l + m] from in[l + m].
template <int l, int N, class C, class T>
ZONAL_INLINE constexpr void turn_degree(const C* in, const TurnAboutZ<N, T>& turn, C* out) {
  using Number = number_t<C>;
  out[l] = in[l];
  unroll<1, l + 1>([&](auto m) ZONAL_INLINE {
    turn_pair(Number(turn.cosine[m]), Number(turn.sine[m]), in[l + m], in[l - m], out[l + m], out[l - m]);
  });
}

/// Degree l of a function with y and z exchanged.
template <int l, class C>
ZONAL_INLINE constexpr void swap_degree(const C* in, C* out) {
  using Number = number_t<C>;
  unroll<-l, l + 1>([&](auto m) ZONAL_INLINE {
    constexpr auto first = rounded<Number>(swap_matrix<l>(m, swap_order(l, m, 0)));
    const C& value = in[l + swap_order(l, m, 0)];
    if constexpr (l == 1 && first > 0) {
      out[l + m] = value;
      return;
    } else if constexpr (l == 1 && !is_colour_v<C>) {
      out[l + m] = -value;
      return;
    }
    C sum = times(Number(first), value);
    unroll<1, swap_terms(l, m)>([&](auto i) ZONAL_INLINE {
      constexpr int k = swap_order(l, m, i);
      constexpr auto entry = rounded<Number>(swap_matrix<l>(m, k));
      add_times(sum, Number(entry), in[l + k]);
    });
    out[l + m] = sum;
  });
}

}  // namespace detail

/// A rotation, or a rotation and a reflection, prepared for functions of up to N bands: of T, a number, for
/// coefficients that are numbers of T, or colours of them.
template <int N, class T>
class Rotation {
  using Pair = detail::CosineAndSine<T>;

 public:
  /// The rotation by nothing.
  constexpr Rotation() : Rotation(Pair{T(1), T(0)}, Pair{T(1), T(0)}, Pair{T(1), T(0)}, T(1)) {}

  /// By where the axes x, y and z go, the columns of its matrix: Rotation::from_axes(m[0], m[1], m[2]) of a GLM matrix,
  /// from_axes(m.col(0), m.col(1), m.col(2)) of Eigen's. They are at right angles, else it is no rotation, and of equal
  /// length, 1e-12 to 1e12; left-handed ones reflect as well. What is no number gives no numbers.
  template <class V>
  ZONAL_INLINE static constexpr Rotation from_axes(const V& x_axis, const V& y_axis, const V& z_axis) {
    const auto x = detail::as_direction<T>(x_axis), y = detail::as_direction<T>(y_axis),
               z = detail::as_direction<T>(z_axis);
    const T across2 = x.z * x.z + y.z * y.z;
    const T for_cos = x.y * y.z - x.z * y.y, for_sin = x.z * y.x - x.x * y.z;
    const T volume = for_cos * z.x + for_sin * z.y + (x.x * y.y - x.y * y.x) * z.z;
    const T parity = select(volume < T(0), T(-1), T(1)) + T(0) * volume;  // no number of what is none
    const T across = detail::inverse_length(across2), scale = parity / sqrt(across2 + z.z * z.z);
    const auto is_tilted = T(0) < across;
    const T cc = select(is_tilted, -(across * x.z), T(1)), sc = select(is_tilted, across * y.z, T(0));
    const T ca = scale * select(is_tilted, across * for_cos, y.y);
    const T sa = scale * select(is_tilted, across * for_sin, -y.x);
    const T to_unit = T(1.5) - T(0.5) * (ca * ca + sa * sa);  // the inverse length of what is next to it, by Newton
    return Rotation(Pair{to_unit * ca, to_unit * sa}, Pair{scale * z.z, scale * (across * across2)}, Pair{cc, sc},
                    parity);
  }

  /// By a quaternion w + x i + y j + z k, of any length but 0, which gives no numbers: d becomes q d q^-1.
  ZONAL_INLINE static constexpr Rotation from_quaternion(const T& w, const T& x, const T& y, const T& z) {
    // By the half sums: (w, z) is cos(b/2) times the cosine and sine of (a + c)/2, (y, -x) sin(b/2) times those of
    // (a - c)/2. Nothing cancels.
    const T upright2 = w * w + z * z, tilted2 = x * x + y * y, per_length2 = T(1) / (upright2 + tilted2);
    const T upright = detail::inverse_length(upright2), tilted = detail::inverse_length(tilted2);
    const auto is_upright = T(0) < upright, is_tilted = T(0) < tilted;
    const Pair sum{select(is_upright, w * upright, T(1)), select(is_upright, z * upright, T(0))};
    const Pair difference{select(is_tilted, y * tilted, T(1)), select(is_tilted, -(x * tilted), T(0))};
    const T cosine = (upright2 - tilted2) * per_length2,
            sine = T(2) * (upright2 * upright) * (tilted2 * tilted) * per_length2;
    return Rotation(Pair{sum.cosine * difference.cosine - sum.sine * difference.sine,
                         sum.sine * difference.cosine + sum.cosine * difference.sine},
                    Pair{cosine, sine},
                    Pair{sum.cosine * difference.cosine + sum.sine * difference.sine,
                         sum.sine * difference.cosine - sum.cosine * difference.sine},
                    T(1));
  }

  /// By an axis, a unit vector, and an angle in radians, counterclockwise as seen from the axis' end. Built-in numbers.
  template <class V>
  static Rotation from_axis_angle(const V& axis, T angle) {
    const auto v = detail::as_direction<T>(axis);
    const T cosine = std::cos(angle / T(2)), sine = std::sin(angle / T(2));
    return from_quaternion(cosine, sine * v.x, sine * v.y, sine * v.z);
  }

  /// Rz(a) Ry(b) Rz(c): by c about z, then by b about y, then by a about z, the axes staying where they are. Radians.
  /// Built-in numbers.
  static Rotation from_zyz(T a, T b, T c) {
    return Rotation(Pair{std::cos(a), std::sin(a)}, Pair{std::cos(b), std::sin(b)}, Pair{std::cos(c), std::sin(c)},
                    T(1));
  }

  /// Exact: the same numbers backwards.
  constexpr Rotation inverse() const {
    return Rotation(third_.inverse(), second_.inverse(), first_.inverse(), parity_);
  }

  /// Where the axes x, y and z go: axes[i] is that of axis i.
  constexpr void get_axes(T (&axes)[3][3]) const {
    const T ca = third_.cosine[1], sa = third_.sine[1], cb = second_.cosine[1], sb = -second_.sine[1];
    const T cc = first_.cosine[1], sc = first_.sine[1];
    const T columns[3][3] = {{ca * cb * cc - sa * sc, sa * cb * cc + ca * sc, -sb * cc},
                             {-ca * cb * sc - sa * cc, ca * cc - sa * cb * sc, sb * sc},
                             {ca * sb, sa * sb, cb}};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) axes[i][k] = parity_ * columns[i][k];
    }
  }

  /// a after b.
  friend constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
    T outer[3][3], inner[3][3], product[3][3] = {};
    a.get_axes(outer);
    b.get_axes(inner);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) product[i][k] = product[i][k] + inner[i][j] * outer[j][k];
      }
    }
    return from_axes(product[0], product[1], product[2]);
  }

  /// -1 where it reflects, or 1.
  constexpr const T& parity() const { return parity_; }

  /// Degree l < N of a function, orders -l to l, not in place.
  template <int l, class C>
  ZONAL_INLINE constexpr void rotate_degree(const C* in, C* out) const {
    C turned[static_cast<std::size_t>(2 * l + 1)], swapped[static_cast<std::size_t>(2 * l + 1)];
    detail::turn_degree<l>(in, first_, turned);
    detail::swap_degree<l>(turned, swapped);
    detail::turn_degree<l>(swapped, second_, turned);
    detail::swap_degree<l>(turned, swapped);
    detail::turn_degree<l>(swapped, third_, out);
  }

  /// The turns by c, by -b and by a about z, in this order: their numbers are all there is to a rotation, and what a
  /// shader's zonal_rotate takes.
  constexpr const TurnAboutZ<N, T>& turn(int i) const { return i == 0 ? first_ : i == 1 ? second_ : third_; }
  constexpr Rotation(const TurnAboutZ<N, T>& first, const TurnAboutZ<N, T>& second, const TurnAboutZ<N, T>& third,
                     const T& parity = T(1))
      : first_(first), second_(second), third_(third), parity_(parity) {}

 private:
  ZONAL_INLINE constexpr Rotation(const Pair& a, const Pair& b, const Pair& c, const T& parity)
      : first_(c.cosine, c.sine), second_(b.cosine, -b.sine), third_(a.cosine, a.sine), parity_(parity) {}

  TurnAboutZ<N, T> first_, second_, third_;
  T parity_;
};

namespace detail {

// Colours of three numbers next to each other as four lanes each. The last is read so that nothing beyond it is.
template <int N, class C>
ZONAL_INLINE inline Sh<N, Lanes<number_t<C>, 4>> as_lanes(const Sh<N, C>& f) {
  using Colour = Lanes<number_t<C>, 4>;
  struct Later {
    static constexpr int at(int i) { return i < 3 ? i + 1 : 3; }
  };
  constexpr int last = N * N - 1;
  const number_t<C>* numbers = numbers_of(f.values);
  Sh<N, Colour> r;
  for (int i = 0; i < last; ++i) r.values[i] = Colour::load(numbers + 3 * i);
  const Colour from_before = Colour::load(numbers + 3 * last - 1);
  r.values[last] = Colour::template shuffle<Later>(from_before, from_before);
  return r;
}
template <int N, class C>
ZONAL_INLINE inline void store_lanes(const Sh<N, Lanes<number_t<C>, 4>>& lanes, Sh<N, C>& to) {
  constexpr int last = N * N - 1;
  number_t<C>* numbers = numbers_of(to.values);
  for (int i = 0; i < last; ++i) lanes.values[i].store(numbers + 3 * i);  // and one more, which the next writes again
  number_t<C> rest[4];
  lanes.values[last].store(rest);
  for (int c = 0; c < 3; ++c) numbers[3 * last + c] = rest[c];
}

}  // namespace detail

/// A function rotated. T may be a colour; the rotation may be prepared for more bands.
template <int N, class C, int M, class T>
ZONAL_DEVICE constexpr Sh<N, C> rotate(const Sh<N, C>& f, const Rotation<M, T>& rotation) {
  static_assert(N <= M, "the rotation is prepared for fewer bands than the function has");
  Sh<N, C> r;
  if constexpr (kLanesAreRegisters && N > 1 && detail::plain_length_v<C> == 3) {
    detail::store_lanes(rotate(detail::as_lanes(f), rotation), r);
    return r;
  }
  r.values[0] = f.values[0];
  unroll<1, N>([&](auto l) ZONAL_INLINE { rotation.template rotate_degree<l>(f.values + l * l, r.values + l * l); });
  if constexpr (is_builtin_scalar_v<T>) {
    if (rotation.parity() > T(0)) return r;  // one branch for all degrees: compilers then schedule them together
  }
  for (int l = 1; l < N; l += 2) {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
      r.values[i] = detail::times(detail::number_t<C>(rotation.parity()), r.values[i]);
    }
  }
  return r;
}

/// A function turned about z, in 4 multiplications a pair of orders.
template <int N, class C, int M, class T>
ZONAL_DEVICE constexpr Sh<N, C> rotate(const Sh<N, C>& f, const TurnAboutZ<M, T>& turn) {
  static_assert(N <= M, "the turn is prepared for fewer bands than the function has");
  Sh<N, C> r;
  unroll<0, N>([&](auto l) ZONAL_INLINE { detail::turn_degree<l>(f.values + l * l, turn, r.values + l * l); });
  return r;
}

/// The same by an angle's cosine and sine, from x towards y.
template <int N, class C, class T>
ZONAL_DEVICE constexpr Sh<N, C> rotate_about_z(const Sh<N, C>& f, const T& cos_angle, const T& sin_angle) {
  return rotate(f, TurnAboutZ<N, T>(cos_angle, sin_angle));
}

/// How a function changes when it is rotated on: by the components of the rotation vector, in radians, at 0. Of a
/// rotated function, that of the rotation that comes last.
template <int N, class C>
struct RotationDerivative {
  Sh<N, C> x, y, z;
};

namespace detail {
// Of the steps from m to m + 1 that a rotation about x or y makes; from 0 they have a factor of sqrt(2) more.
constexpr long double turning_step(int l, int m) {
  return constexpr_sqrt((l - m) * (l + m + 1.0L)) * (m == 0 ? constexpr_sqrt(0.5L) : 0.5L);
}
}  // namespace detail

/// The generators of rotations: exact, 8 multiplications a pair of orders.
template <int N, class C>
ZONAL_DEVICE constexpr RotationDerivative<N, C> rotation_derivative(const Sh<N, C>& f) {
  using Number = detail::number_t<C>;
  RotationDerivative<N, C> r;
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    constexpr int centre = l * l + l;
    const C* in = f.values + centre;
    C *x = r.x.values + centre, *y = r.y.values + centre, *z = r.z.values + centre;
    const C none = detail::zero<C>(0);
    x[0] = y[0] = z[0] = none;
    unroll<1, l + 1>([&](auto m) ZONAL_INLINE {
      z[m] = detail::times(Number(-m), in[-m]);
      z[-m] = detail::times(Number(int(m)), in[m]);
      x[m] = x[-m] = y[m] = y[-m] = none;
    });
    unroll<0, l>([&](auto m) ZONAL_INLINE {  // between m and m + 1
      constexpr auto constant = rounded<Number>(detail::turning_step(l, m));
      const Number step(constant);
      detail::add_times(y[m], step, in[m + 1]);
      detail::subtract_times(y[m + 1], step, in[m]);
      detail::subtract_times(x[m], step, in[-m - 1]);
      detail::add_times(x[-m - 1], step, in[m]);
      if constexpr (m > 0) {
        detail::add_times(y[-m], step, in[-m - 1]);
        detail::subtract_times(y[-m - 1], step, in[-m]);
        detail::add_times(x[-m], step, in[m + 1]);
        detail::subtract_times(x[m + 1], step, in[-m]);
      }
    });
  });
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
