// The weights of the three interpolations between the 8 corners of a cell, as kernels on any scalar.
//
// Trilinear, Taylor and Hermite are one formula. With t in [0,1] across the cell, each axis gives each of its two ends
// three numbers: `linear` (l), the hat; `bump` (b), what a cubic adds to it; and `slope` (s), the weight of a
// derivative. With p = t (1-t), at the ends t = 0 and t = 1:
//
//              l           b                      s, times the cell's size
//   trilinear  1-t, t      0                      0
//   Taylor     1-t, t      0                      p, -p               offset from the end times hat        [1]
//   Hermite    1-t, t      p (1-2t), -p (1-2t)    p (1-t), -p t       l+b = h00, h01 and s = h10, h11      [2]
//
// and a corner weighs its value and its derivatives by x, y and z with
//
//   l_x l_y l_z + b_x l_y l_z + l_x b_y l_z + l_x l_y b_z,   s_x l_y l_z,   l_x s_y l_z,   l_x l_y s_z
//
// which is linear in the three numbers of each axis: the weights' derivative along x is the same formula with the
// derivatives of x's three.
//
// Taylor is Annen et al.'s [1] expansion about every corner, averaged with the trilinear weights. Its leading error is
// the trilinear one with the other sign (t^2 becomes t^2 - p, not t^2 + p): of the same size, at four times the memory.
//
// Hermite [2] is cubic along each axis. A cubic in x, y and z needs cross derivatives too, which no vertex has. Here
// they come from the cell's own corners (D_x: the difference of two corners over their distance):
//
//   f_xy = D_x f_y + D_y f_x - D_x D_y f     f_xyz = D_y D_z f_x + D_x D_z f_y + D_x D_y f_z - 2 D_x D_y D_z f
//
// Adini's choice, in which the leading errors of the terms cancel. It makes the interpolant the formula above: what
// trilinear gives, plus the cubic's share along each axis, blended linearly across it. All polynomials of degree 3 come
// out exactly, and so do cubics in one coordinate times linears in the others: the error is O(h^4). Values are
// continuous; the derivative across a face is exact at its corners and jumps by O(h^3) elsewhere. Zero cross
// derivatives would leave no jump, but an error of O(h^2).
//
// Mean error in 1e-4 of the mean |coefficient|, 5 bands, box from -1 to 1; time and memory against trilinear:
//
//                                                sphere of .4 at (1.6, .7, .9)   of .3 at (.3, 1.5, -.2)
//   cross derivatives                    reads      8^3     16^3                    8^3     16^3
//   (trilinear)                              8      367     83.7                    560     122
//   (Taylor)                                32      360     83.4                    552     122
//   zero                                    32     30.4     4.18                   54.3     6.86
//   mean of D_x f_y and D_y f_x, in cell    32     19.5     1.58                   38.1     2.80
//   Hermite along x, then y, then z (*)     32     22.1     1.91                   42.7     3.45
//   Adini, in cell (this one)               32     16.8     0.95                   35.4     1.77
//   central differences, stored             64     11.4     0.57                   23.8     1.07
//   Adini by central differences, stored    64     10.8     0.50                   23.2     1.02
//   the same in this one's memory           64     45.1     1.24                   104      2.55     (6^3, 13^3)
//   (trilinear in this one's memory)         8      130     33.0                   195      49.0    (13^3, 25^3)
//
// (*) f_y and f_z linear in x, then f_z in y. The jump of the derivative across faces, of the mean |gradient|:
// trilinear 0.58 at 8^3 and 0.30 at 16^3, this one 0.039 and 0.0048, zero 0; but the derivative itself is off by 0.013
// and 0.0014, with zero by 0.031 and 0.010.
//
// [1] Annen et al., Spherical harmonic gradients for mid-range illumination, EGSR 2004.
// [2] Wu et al., Analytic spherical harmonic gradients for real-time rendering with many polygonal area lights, TOG
//     39(4), 2020.
#pragma once

#include <cstddef>

#include "../scalar/scalar.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// Cells per unit of length on an axis, and where a coordinate lies on it in units of cells: 0 to vertices - 1.
template <class T>
ZONAL_INLINE constexpr T cell_rate(const T& low, const T& high, const T& vertices) {
  return (vertices - T(1)) / (high - low);
}
template <class T>
ZONAL_INLINE constexpr T cell_position(const T& x, const T& low, const T& rate, const T& vertices) {
  return clamp((x - low) * rate, T(0), vertices - T(1));
}
}  // namespace detail

enum class Interpolation { trilinear, taylor, hermite };

/// The blocks of a vertex that an interpolation reads: the value, or the value and its three derivatives.
constexpr int blocks_read(Interpolation method) { return method == Interpolation::trilinear ? 1 : 4; }

/// What an axis gives its two ends, or the derivatives of that. Units: slope is a length.
template <class T>
struct AxisWeights {
  T linear[2], bump[2], slope[2];
};

/// The weights at t, 0 to 1 across a cell of this size.
template <Interpolation method, class T>
ZONAL_INLINE constexpr AxisWeights<T> axis_weights(const T& t, const T& size) {
  const T rest = T(1) - t, p = t * rest;
  if constexpr (method == Interpolation::hermite) {
    const T bump = p * (rest - t);
    return {{rest, t}, {bump, -bump}, {size * (p * rest), -(size * (p * t))}};
  } else if constexpr (method == Interpolation::taylor) {
    return {{rest, t}, {T(0), T(0)}, {size * p, -(size * p)}};
  } else {
    return {{rest, t}, {T(0), T(0)}, {T(0), T(0)}};
  }
}

/// Their derivatives by position. `rate` is that of t: 1/size, or 0 where t does not move with the position.
template <Interpolation method, class T>
ZONAL_INLINE constexpr AxisWeights<T> axis_weight_derivatives(const T& t, const T& size, const T& rate) {
  const T rest = T(1) - t, p = t * rest, scale = size * rate;
  if constexpr (method == Interpolation::hermite) {
    const T bump = rate * (T(1) - T(6) * p);
    return {{-rate, rate}, {bump, -bump}, {scale * (rest * (rest - (t + t))), scale * (t * ((t - rest) - rest))}};
  } else if constexpr (method == Interpolation::taylor) {
    const T slope = scale * (rest - t);
    return {{-rate, rate}, {T(0), T(0)}, {slope, -slope}};
  } else {
    return {{-rate, rate}, {T(0), T(0)}, {T(0), T(0)}};
  }
}

/// Corner c is at the far end of x, y and z by bits 0, 1 and 2 of c; its weights are those of the value and, if read,
/// of the derivatives by x, y and z.
template <Interpolation method, class T>
struct CellWeights {
  T corner[8][static_cast<std::size_t>(blocks_read(method))];
};

/// The weights of the 8 corners, of the interpolant or, with the derivatives of one axis, of its derivative along it.
template <Interpolation method, class T>
ZONAL_INLINE constexpr CellWeights<method, T> cell_weights(const AxisWeights<T>& x, const AxisWeights<T>& y,
                                                           const AxisWeights<T>& z) {
  CellWeights<method, T> weights{};
  unroll<0, 4>([&](auto edge) ZONAL_INLINE {  // the edges along x
    constexpr int j = edge % 2, k = edge / 2;
    const T linear = y.linear[j] * z.linear[k];
    T value = linear;
    if constexpr (method == Interpolation::hermite) {
      value = linear + (y.bump[j] * z.linear[k] + y.linear[j] * z.bump[k]);
    }
    unroll<0, 2>([&](auto i) ZONAL_INLINE {
      auto& corner = weights.corner[i + 2 * edge];
      corner[0] = x.linear[i] * value;
      if constexpr (method == Interpolation::hermite) corner[0] = corner[0] + x.bump[i] * linear;
      if constexpr (method != Interpolation::trilinear) {
        corner[1] = x.slope[i] * linear;
        corner[2] = x.linear[i] * (y.slope[j] * z.linear[k]);
        corner[3] = x.linear[i] * (y.linear[j] * z.slope[k]);
      }
    });
  });
  return weights;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
