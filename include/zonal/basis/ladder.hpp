// The ladder: derivatives of harmonics as sums of harmonics one degree up and one down.
//
// A coordinate times a harmonic of degree l is a sum of harmonics of degrees l+1 and l-1, with constant coefficients, a
// step up and a step down,
//
//   v_k Y_l^m = U_k[Y_(l+1)] + D_k[Y_(l-1)]
//
// and the gradient of f(d) Y_l^m(v/d), d = |v|, is a weighted sum of the same two terms:
//
//   d/dv_k (f Y_l^m) = (f' - l f/d) U_k[Y_(l+1)] + (f' + (l+1) f/d) D_k[Y_(l-1)]
//
// or, U_k being the rest of v_k Y_l^m, with the step down alone where Y_l^m itself is at hand (v of unit length):
//
//   d/dv_k (f Y_l^m) = (f' - l f/d) v_k Y_l^m + (2l+1) f/d D_k[Y_(l-1)]
//
// No angle, no division, no pole.
#pragma once

#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"
#include "sh.hpp"
#include "table.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// U_k and D_k. z keeps the order m; x and y go to m+1 (raise) and m-1 (lower), with a factor 1/2 for
// cos(phi) cos(m phi) = (cos((m+1) phi) + cos((m-1) phi)) / 2, or sqrt(1/2) from or to m = 0, whose normalisation lacks
// sqrt(2); and a sign for the Condon-Shortley phase.
constexpr long double ladder_root(long double a, long double b, long double c, long double d) {
  return constexpr_sqrt(a * b / (c * d));
}
constexpr long double ladder_half(bool zero) { return zero ? constexpr_sqrt(0.5L) : 0.5L; }
constexpr long double keep_up(int l, int m) { return ladder_root(l + 1 - m, l + 1 + m, 2 * l + 1, 2 * l + 3); }
constexpr long double keep_down(int l, int m) { return ladder_root(l - m, l + m, 2 * l - 1, 2 * l + 1); }
constexpr long double raise_up(int l, int m) {
  return -ladder_half(m == 0) * ladder_root(l + m + 1, l + m + 2, 2 * l + 1, 2 * l + 3);
}
constexpr long double raise_down(int l, int m) {
  return ladder_half(m == 0) * ladder_root(l - m, l - m - 1, 2 * l - 1, 2 * l + 1);
}
constexpr long double lower_up(int l, int m) {
  return ladder_half(m == 1) * ladder_root(l - m + 1, l - m + 2, 2 * l + 1, 2 * l + 3);
}
constexpr long double lower_down(int l, int m) {
  return -ladder_half(m == 1) * ladder_root(l + m, l + m - 1, 2 * l - 1, 2 * l + 1);
}

// The three by name: the factors of the steps from degree l to the neighbours, at an order m >= 0.
enum class Rung { keep, raise, lower };
template <Rung rung, int l, int m>
inline constexpr long double rung_up = rung == Rung::keep    ? keep_up(l, m)
                                       : rung == Rung::raise ? raise_up(l, m)
                                                             : lower_up(l, m);
template <Rung rung, int l, int m>
inline constexpr long double rung_down = rung == Rung::keep    ? keep_down(l, m)
                                         : rung == Rung::raise ? raise_down(l, m)
                                                               : lower_down(l, m);

// The weights of the two steps where they are known at compile time.
struct UnitWeights {  // the two terms as they come: weighted before, or after
  static constexpr int up(int) { return 1; }
  static constexpr int down(int) { return 1; }
};
struct AngularWeights {  // f = 1
  static constexpr int up(int l) { return -l; }
  static constexpr int down(int l) { return l + 1; }
};
struct InverseDistanceWeights {  // f = 1/d
  static constexpr int up(int l) { return -(l + 1); }
  static constexpr int down(int l) { return l; }
};
struct SolidWeights {  // f = d^l, a polynomial
  static constexpr int up(int) { return 0; }
  static constexpr int down(int l) { return 2 * l + 1; }
};

// A term that is not there, and costs nothing.
struct NoTerm {
  template <class T>
  explicit constexpr operator T() const {
    return T(0);
  }
  friend constexpr NoTerm operator+(NoTerm, NoTerm) { return {}; }
  friend constexpr NoTerm operator-(NoTerm, NoTerm) { return {}; }
  template <class T>
  friend ZONAL_INLINE constexpr T operator+(const T& a, NoTerm) {
    return a;
  }
  template <class T>
  friend ZONAL_INLINE constexpr T operator+(NoTerm, const T& a) {
    return a;
  }
  template <class T>
  friend ZONAL_INLINE constexpr T operator-(const T& a, NoTerm) {
    return a;
  }
  template <class T>
  friend ZONAL_INLINE constexpr T operator-(NoTerm, const T& a) {
    return -a;
  }
};

// The step of the harmonic (l, +-m) to the neighbours' order `order`: up * above(order) + down * below(order).
template <Rung rung, int l, int m, int order, class T, class Weights, class Above, class Below>
ZONAL_INLINE constexpr auto step(const Above& above, const Below& below) {
  constexpr bool has_above = Weights::up(l) != 0, has_below = Weights::down(l) != 0 && order < l && -l < order;
  constexpr auto up = rounded<T>(Weights::up(l) * rung_up<rung, l, m>);
  if constexpr (has_above && has_below) {
    constexpr auto down = rounded<T>(Weights::down(l) * rung_down<rung, l, m>);
    return T(up) * above(Index<order>{}) + T(down) * below(Index<order>{});
  } else if constexpr (has_above) {
    return T(up) * above(Index<order>{});
  } else if constexpr (has_below) {
    constexpr auto down = rounded<T>(Weights::down(l) * rung_down<rung, l, m>);
    return T(down) * below(Index<order>{});
  } else {
    return NoTerm{};
  }
}

// The values of degree l of an array: a callable on Index<m>.
template <int l, class T>
struct DegreeOf {
  const T* values;  // of all degrees
  template <int m>
  ZONAL_INLINE constexpr const T& operator()(Index<m>) const {
    return values[sh_index(l, m)];
  }
};

// The gradient of degree l from the values of its neighbours: sink(m, x, y, z). `above` and `below` are callables on
// Index<m>, for degrees l+1 and l-1. A neighbour that is not there, or has no weight, costs nothing. The steps are
// templates of nothing that changes with the sink or with the number of bands, so that they are compiled once.
template <int l, class T, class Weights, class Above, class Below, class Sink>
ZONAL_INLINE constexpr void ladder(const Above& above, const Below& below, Sink&& sink) {
  unroll<0, l + 1>([&](auto m) ZONAL_INLINE {
    const auto raise_c = step<Rung::raise, l, m, m + 1, T, Weights>(above, below);
    const auto raise_s = step<Rung::raise, l, m, -m - 1, T, Weights>(above, below);
    const auto keep_c = step<Rung::keep, l, m, m, T, Weights>(above, below);
    if constexpr (m == 0) {
      sink(m, T(raise_c), T(raise_s), T(keep_c));
    } else {
      const auto lower_c = step<Rung::lower, l, m, m - 1, T, Weights>(above, below);
      const auto keep_s = step<Rung::keep, l, m, -m, T, Weights>(above, below);
      if constexpr (m == 1) {  // sin(0 phi) is no harmonic
        sink(Index<-m>{}, T(raise_s), T(lower_c - raise_c), T(keep_s));
        sink(m, T(raise_c + lower_c), T(raise_s), T(keep_c));
      } else {
        const auto lower_s = step<Rung::lower, l, m, 1 - m, T, Weights>(above, below);
        sink(Index<-m>{}, T(raise_s + lower_s), T(lower_c - raise_c), T(keep_s));
        sink(m, T(raise_c + lower_c), T(raise_s - lower_s), T(keep_c));
      }
    }
  });
}

// The same over all degrees below N, from arrays that hold every neighbour: sink(l, m, x, y, z).
template <int N, class Weights, int M, class T, class Sink>
ZONAL_INLINE constexpr void ladder(const Sh<M, T>& y, Sink&& sink) {
  static_assert(Weights::up(N - 1) == 0 ? M >= N - 1 : M > N, "a neighbour is missing");
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    ladder<l, T, Weights>(DegreeOf<l + 1, T>{y.values}, DegreeOf<l - 1, T>{y.values},
                          [&](auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE { sink(l, m, gx, gy, gz); });
  });
}

}  // namespace detail

}  // namespace ZONAL_TARGET
}  // namespace zonal
