// Gradients and Hessians of the real spherical harmonics, from the harmonics themselves: the ladder (ladder.hpp) with
// f = 1, for which the gradient is constant along rays. Applied twice it is the Hessian.
//
// The papers go through theta and phi and divide by x^2 + y^2 [1, Eq. 17-23]: angular_gradient.hpp.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include "evaluate.hpp"
#include "gradient_rows.hpp"
#include "ladder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

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
ZONAL_DEVICE ZONAL_INLINE constexpr void evaluate_with_gradient(const T& x, const T& y, const T& z, Sink&& sink) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  Sh<N, T> basis;
  detail::evaluate_into(basis, x, y, z);
  detail::ladder<N, detail::SolidWeights>(
      basis, [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
        const T& value = basis.values[sh_index(l, m)];
        if constexpr (l == 0) {
          sink(l, m, value, gx, gy, gz);
        } else {
          const T degree = T(int{l});
          sink(l, m, value, gx - degree * x * value, gy - degree * y * value, gz - degree * z * value);
        }
      });
}

namespace detail {
// A sink that keeps value and gradient in arrays of N*N numbers each.
template <class T>
ZONAL_INLINE constexpr auto into(T* value, T* by_x, T* by_y, T* by_z) {
  return [=](auto l, auto m, const T& y, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
    constexpr int i = sh_index(l, m);
    value[i] = y;
    by_x[i] = gx;
    by_y[i] = gy;
    by_z[i] = gz;
  };
}
template <int N, class T>
ZONAL_INLINE constexpr auto into(ShGradient<N, T>& arrays) {
  auto& gradient = arrays.gradient;
  return into(arrays.value.values, gradient[0].values, gradient[1].values, gradient[2].values);
}

// evaluate_with_gradient to such arrays, by the fastest way there is.
template <int N, class T>
ZONAL_DEVICE ZONAL_INLINE constexpr void evaluate_with_gradient_into(const T& x, const T& y, const T& z, T* value,
                                                                     T* by_x, T* by_y, T* by_z) {
  if constexpr (is_builtin_scalar_v<T> && N >= least_bands_in_rows) {
    gradient_in_rows<N>(x, y, z, value, by_x, by_y, by_z);
  } else {
    evaluate_with_gradient<N>(x, y, z, into(value, by_x, by_y, by_z));
  }
}
}  // namespace detail

/// The same as arrays, at anything with v[0], v[1], v[2], or v.x, v.y, v.z.
template <int N, class Direction>
ZONAL_DEVICE ShGradient<N, component_t<Direction>> evaluate_with_gradient(const Direction& direction) {
  using T = component_t<Direction>;
  const auto [x, y, z] = detail::as_direction<T>(direction);
  ShGradient<N, T> result;
  auto& gradient = result.gradient;
  detail::evaluate_with_gradient_into<N, T>(x, y, z, result.value.values, gradient[0].values, gradient[1].values,
                                            gradient[2].values);
  return result;
}

namespace detail {
// The gradient of Y(v/|v|) is a sum of harmonics over |v|, so its own needs the gradients of these.
template <int N, class T>
ZONAL_DEVICE ShHessian<N, T> hessian_unrolled(const T& x, const T& y, const T& z) {
  Sh<N + 2, T> basis;
  evaluate_into(basis, x, y, z);
  Sh<N + 1, T> slopes[3];
  ladder<N + 1, InverseDistanceWeights>(basis, [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
    constexpr int i = sh_index(l, m);
    slopes[0].values[i] = gx, slopes[1].values[i] = gy, slopes[2].values[i] = gz;
  });

  ShHessian<N, T> result;
  for (int i = 0; i < N * N; ++i) result.value.values[i] = basis.values[i];
  const auto put = [&](const auto& values, Sh<N, T>* by_x, Sh<N, T>* by_y, Sh<N, T>* by_z) ZONAL_INLINE {
    ladder<N, AngularWeights>(values, [&](auto l, auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
      constexpr int i = sh_index(l, m);
      if (by_x) by_x->values[i] = gx;
      if (by_y) by_y->values[i] = gy;
      if (by_z) by_z->values[i] = gz;
    });
  };
  put(basis, &result.gradient[0], &result.gradient[1], &result.gradient[2]);
  put(slopes[0], &result.hessian[0], nullptr, nullptr);
  put(slopes[1], &result.hessian[1], &result.hessian[3], nullptr);
  put(slopes[2], &result.hessian[2], &result.hessian[4], &result.hessian[5]);
  return result;
}

// The same in loops: as fast from 8 bands on, where the other takes a compiler long, a minute and more for 21 bands.
template <int N, class T>
ShHessian<N, T> hessian_in_rows(const T& x, const T& y, const T& z) {
  PaddedRows<N + 2, T> basis;
  PaddedRows<N + 1, T> slopes[3];
  evaluate<N + 2>(x, y, z,
                  [&](auto l, auto m, const T& value) ZONAL_INLINE { basis.values()[sh_index(l, m)] = value; });
  ladder_in_rows<N + 1, InverseDistanceWeights>(basis, slopes[0].values(), slopes[1].values(), slopes[2].values());

  ShHessian<N, T> result;
  for (int i = 0; i < N * N; ++i) result.value.values[i] = basis.values()[i];
  T* none = nullptr;
  auto& gradient = result.gradient;
  auto& hessian = result.hessian;
  ladder_in_rows<N, AngularWeights>(basis, gradient[0].values, gradient[1].values, gradient[2].values);
  ladder_in_rows<N, AngularWeights>(slopes[0], hessian[0].values, none, none);
  ladder_in_rows<N, AngularWeights>(slopes[1], hessian[1].values, hessian[3].values, none);
  ladder_in_rows<N, AngularWeights>(slopes[2], hessian[2].values, hessian[4].values, hessian[5].values);
  return result;
}
}  // namespace detail

/// Value, gradient and Hessian of Y_l^m(v/|v|) at the unit vector v.
template <int N, class Direction>
ZONAL_DEVICE ShHessian<N, component_t<Direction>> evaluate_with_hessian(const Direction& direction) {
  using T = component_t<Direction>;
  static_assert(N >= 1, "bands out of range: N >= 1");
  const auto v = detail::as_direction<T>(direction);
  if constexpr (N >= detail::least_hessian_in_rows) {
    return detail::hessian_in_rows<N, T>(v.x, v.y, v.z);
  } else {
    return detail::hessian_unrolled<N, T>(v.x, v.y, v.z);
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
