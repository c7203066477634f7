// Gradients and Hessians of the real spherical harmonics, from the harmonics themselves.
//
// A coordinate times a harmonic of degree l is a sum of harmonics of degrees l+1 and l-1, with constant coefficients: a
// ladder of one step up and one down,
//
//   v_k Y_l^m = U_k[Y_(l+1)] + D_k[Y_(l-1)]
//
// and the gradient of f(d) Y_l^m(v/d), d = |v|, is a weighted sum of the same two terms:
//
//   d/dv_k (f Y_l^m) = (f' - l f/d) U_k[Y_(l+1)] + (f' + (l+1) f/d) D_k[Y_(l-1)]
//
// (for f = d^l, a polynomial, the first weight is zero; for f = d^-(l+1) the second.) No angle, no division, no pole.
// With f = 1 it is the gradient of the harmonic, constant along rays; applied twice, the Hessian. The papers go through
// theta and phi and divide by x^2 + y^2 [1, Eq. 17-23]: reference/angular_gradient.hpp.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include "evaluate.hpp"

namespace zonal {

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

// The weights of the two steps where they are known at compile time.
struct UnitWeights {  // the two terms as they come: weighted before, or after
  static constexpr long double up(int) { return 1; }
  static constexpr long double down(int) { return 1; }
};
struct AngularWeights {  // f = 1
  static constexpr long double up(int l) { return -l; }
  static constexpr long double down(int l) { return l + 1; }
};
struct InverseDistanceWeights {  // f = 1/d
  static constexpr long double up(int l) { return -(l + 1); }
  static constexpr long double down(int l) { return l; }
};

// up * above(m) + down * below(m): the step from degree l to its neighbours, at order m. A neighbour that is not there,
// or has no weight, costs nothing. `above` and `below` are callables on Index<m>, for degrees l+1 and l-1.
template <int l, int m, class T, class Above, class Below>
ZONAL_INLINE constexpr T step(const T& up, const T& down, Above&& above, Below&& below) {
  constexpr bool has_below = m < l && -l < m;
  if constexpr (has_below) return up * above(Index<m>{}) + down * below(Index<m>{});
  return up * above(Index<m>{});
}

// The gradient of degree l from the values of its neighbours: sink(m, x, y, z).
template <int l, class T, class Weights, class Above, class Below, class Sink>
ZONAL_INLINE constexpr void ladder(Above&& above, Below&& below, Sink&& sink) {
  constexpr long double up = Weights::up(l), down = Weights::down(l);
  unroll<0, l + 1>([&](auto m) ZONAL_INLINE {
    const auto keep = [&](auto order) ZONAL_INLINE {
      return step<l, order, T>(T(up * keep_up(l, m)), T(down * keep_down(l, m)), above, below);
    };
    const auto raise = [&](auto order) ZONAL_INLINE {
      return step<l, order, T>(T(up * raise_up(l, m)), T(down * raise_down(l, m)), above, below);
    };
    const auto lower = [&](auto order) ZONAL_INLINE {
      return step<l, order, T>(T(up * lower_up(l, m)), T(down * lower_down(l, m)), above, below);
    };
    const T raise_c = raise(Index<m + 1>{}), raise_s = raise(Index<-m - 1>{});
    if constexpr (m == 0) {
      sink(Index<0>{}, raise_c, raise_s, keep(Index<0>{}));
    } else if constexpr (m == 1) {  // sin(0 phi) is no harmonic
      const T lower_c = lower(Index<0>{});
      sink(Index<-1>{}, raise_s, lower_c - raise_c, keep(Index<-1>{}));
      sink(Index<1>{}, raise_c + lower_c, raise_s, keep(Index<1>{}));
    } else {
      const T lower_c = lower(Index<m - 1>{}), lower_s = lower(Index<1 - m>{});
      sink(Index<-m>{}, raise_s + lower_s, lower_c - raise_c, keep(Index<-m>{}));
      sink(m, raise_c + lower_c, raise_s - lower_s, keep(m));
    }
  });
}

// The same over all degrees below N, from arrays of at least N+1 bands: sink(l, m, x, y, z).
template <int N, class Weights, int M, class T, class Sink>
ZONAL_INLINE constexpr void ladder(const Sh<M, T>& y, Sink&& sink) {
  static_assert(M > N, "the gradient needs one band more");
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    if constexpr (l == 0 && Weights::up(0) == 0) {
      sink(l, l, T(0), T(0), T(0));
    } else {
      ladder<l, T, Weights>([&](auto m) ZONAL_INLINE { return y.values[sh_index(l + 1, m)]; },
                            [&](auto m) ZONAL_INLINE { return y.values[sh_index(l - 1, m)]; },
                            [&](auto m, const T& gx, const T& gy, const T& gz)
                                ZONAL_INLINE { sink(l, m, gx, gy, gz); });
    }
  });
}

// evaluate, kept as an array, inside a kernel.
template <int N, class T>
ZONAL_INLINE constexpr void evaluate_into(Sh<N, T>& y, const T& vx, const T& vy, const T& vz) {
  evaluate<N>(vx, vy, vz, [&](auto l, auto m, const T& value) ZONAL_INLINE { y.values[sh_index(l, m)] = value; });
}

}  // namespace detail

/// N*N coefficients or basis values, and their derivatives by x, y and z.
template <int N, class T>
struct ShGradient {
  Sh<N, T> value;
  Sh<N, T> gradient[3];
};

/// The same, and the second derivatives by xx, xy, xz, yy, yz, zz.
template <int N, class T>
struct ShHessian {
  Sh<N, T> value;
  Sh<N, T> gradient[3];
  Sh<N, T> hessian[6];
};

/// Y_l^m and the gradient of Y_l^m(v/|v|) at the unit vector v = (x, y, z): sink(l, m, value, d/dx, d/dy, d/dz).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void evaluate_with_gradient(const T& x, const T& y, const T& z, Sink&& sink) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  Sh<N + 1, T> basis{};
  detail::evaluate_into(basis, x, y, z);
  detail::ladder<N, detail::AngularWeights>(basis,
                                            [&](auto l, auto m, const T& gx, const T& gy, const T& gz)
                                                ZONAL_INLINE { sink(l, m, basis.values[sh_index(l, m)], gx, gy, gz); });
}

/// The same as arrays, at anything with v[0], v[1], v[2].
template <int N, class Direction>
constexpr ShGradient<N, component_t<Direction>> evaluate_with_gradient(const Direction& direction) {
  using T = component_t<Direction>;
  assert(detail::is_unit<T>(direction[0], direction[1], direction[2]));
  ShGradient<N, T> result{};
  evaluate_with_gradient<N>(T(direction[0]), T(direction[1]), T(direction[2]),
                            [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
                              const int i = sh_index(l, m);
                              result.value.values[i] = value;
                              result.gradient[0].values[i] = gx;
                              result.gradient[1].values[i] = gy;
                              result.gradient[2].values[i] = gz;
                            });
  return result;
}

/// Value, gradient and Hessian of Y_l^m(v/|v|) at the unit vector v.
template <int N, class Direction>
constexpr ShHessian<N, component_t<Direction>> evaluate_with_hessian(const Direction& direction) {
  using T = component_t<Direction>;
  static_assert(N >= 1, "bands out of range: N >= 1");
  assert(detail::is_unit<T>(direction[0], direction[1], direction[2]));
  Sh<N + 2, T> basis{};
  detail::evaluate_into(basis, T(direction[0]), T(direction[1]), T(direction[2]));

  // The gradient of Y(v/|v|) is a sum of harmonics over |v|, so its own needs the gradients of these.
  Sh<N + 1, T> slopes[3] = {};
  detail::ladder<N + 1, detail::InverseDistanceWeights>(
      basis, [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
        const int i = sh_index(l, m);
        slopes[0].values[i] = gx, slopes[1].values[i] = gy, slopes[2].values[i] = gz;
      });

  ShHessian<N, T> result{};
  for (int i = 0; i < N * N; ++i) result.value.values[i] = basis.values[i];
  const auto put = [&](const auto& values, Sh<N, T>* x, Sh<N, T>* y, Sh<N, T>* z) ZONAL_INLINE {
    detail::ladder<N, detail::AngularWeights>(values,
                                              [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
                                                const int i = sh_index(l, m);
                                                if (x) x->values[i] = gx;
                                                if (y) y->values[i] = gy;
                                                if (z) z->values[i] = gz;
                                              });
  };
  put(basis, &result.gradient[0], &result.gradient[1], &result.gradient[2]);
  put(slopes[0], &result.hessian[0], nullptr, nullptr);
  put(slopes[1], &result.hessian[1], &result.hessian[3], nullptr);
  put(slopes[2], &result.hessian[2], &result.hessian[4], &result.hessian[5]);
  return result;
}

}  // namespace zonal
