// The basis and its gradient at a direction: the ladder (basis/ladder.hpp) in loops over the orders of a degree.
//
// f = d^l, a polynomial, less what is along the ray: the step down alone, no division, no pole.
#pragma once

#include <cstddef>
#include <vector>

#include "../basis/ladder.hpp"
#include "evaluate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The ladder's factors for the gradient of N bands: 3 N*N/2 numbers beside those of ManyBands.
template <class T>
class ManyGradient {
 public:
  explicit ManyGradient(const ManyBands<T>& bands) : bands_(bands.bands()) {
    for (int l = 0; l < bands_; ++l) {
      const int weight = detail::SolidWeights::down(l);
      for (int m = 0; m <= l; ++m) {
        keep_.push_back(static_cast<T>(weight * detail::keep_down(l, m)));
        raise_.push_back(static_cast<T>(weight * detail::raise_down(l, m)));
        lower_.push_back(static_cast<T>(m == 0 ? 0 : weight * detail::lower_down(l, m)));
      }
    }
  }
  int bands() const { return bands_; }

  /// Of degree l >= 1 and orders 0 to l: the steps to the same order of the degree below, to the next, to the one
  /// before.
  const T* keep(int l) const { return keep_.data() + even_index(l, 0); }
  const T* raise(int l) const { return raise_.data() + even_index(l, 0); }
  const T* lower(int l) const { return lower_.data() + even_index(l, 0); }

 private:
  int bands_;
  std::vector<T> keep_, raise_, lower_;
};

namespace detail {
// The gradient of one degree from its values and those of the degree below, to the order 0 of each array.
template <class T>
void gradient_of_degree(int l, const ManyGradient<T>& ladder, T x, T y, T z, const T* __restrict here,
                        const T* __restrict below, T* __restrict by_x, T* __restrict by_y, T* __restrict by_z) {
  const T *const keep = ladder.keep(l), *const raise = ladder.raise(l), *const lower = ladder.lower(l);
  const T lx = T(l) * x, ly = T(l) * y, lz = T(l) * z;
  by_x[0] = raise[0] * below[1] - lx * here[0];
  by_y[0] = raise[0] * below[-1] - ly * here[0];
  for (int m = 1; m <= l; ++m) {
    by_x[m] = raise[m] * below[m + 1] + lower[m] * below[m - 1] - lx * here[m];
    by_y[-m] = lower[m] * below[m - 1] - raise[m] * below[m + 1] - ly * here[-m];
  }
  for (int m = 1; m <= l; ++m) {
    const T before = m > 1 ? below[1 - m] : T(0);  // sin(0 phi) is no harmonic
    by_x[-m] = raise[m] * below[-m - 1] + lower[m] * before - lx * here[-m];
    by_y[m] = raise[m] * below[-m - 1] - lower[m] * before - ly * here[m];
  }
  for (int m = 0; m <= l; ++m) by_z[m] = keep[m] * below[m] - lz * here[m];
  for (int m = 1; m <= l; ++m) by_z[-m] = keep[m] * below[-m] - lz * here[-m];
}
}  // namespace detail

/// Y_l^m and the gradient of Y_l^m(v/|v|) at the unit vector v, to four arrays of N*N numbers.
template <class T, class Direction>
void evaluate_with_gradient(const ManyBands<T>& bands, const ManyGradient<T>& ladder, const Direction& direction,
                            BasisSpace<T>& space, T* values, T* by_x, T* by_y, T* by_z) {
  assert(ladder.bands() >= bands.bands());
  const auto v = detail::as_direction<T>(direction);
  visit_degrees(bands, direction, space, [&](int l, const T* row) {
    const int centre = sh_index(l, 0);
    std::copy(row - l, row + l + 1, values + l * l);
    if (l == 0) {
      by_x[0] = by_y[0] = by_z[0] = T(0);
    } else {
      detail::gradient_of_degree(l, ladder, v.x, v.y, v.z, row, static_cast<const T*>(space.values(l - 1)),
                                 by_x + centre, by_y + centre, by_z + centre);
    }
  });
}

/// The same, kept.
template <class T>
struct ManyShGradient {
  ManySh<T> value, x, y, z;
};
template <class T, class Direction>
ManyShGradient<T> evaluate_with_gradient(const ManyBands<T>& bands, const ManyGradient<T>& ladder,
                                         const Direction& direction) {
  const int n = bands.bands();
  BasisSpace<T> space(n);
  ManyShGradient<T> r{ManySh<T>(n), ManySh<T>(n), ManySh<T>(n), ManySh<T>(n)};
  evaluate_with_gradient(bands, ladder, direction, space, r.value.data(), r.x.data(), r.y.data(), r.z.data());
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
