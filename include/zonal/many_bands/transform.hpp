// What is done to functions of many bands: orient, convolve, dot, reconstruct, sums of samples.
//
// Coefficients are numbers or colours, in arrays of N*N or N. Directions are unit vectors.
#pragma once

#include "../scalar/colour.hpp"
#include "evaluate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A zonal function with its axis moved from z to `axis`: z has N coefficients, sh takes N*N.
template <class C, class T, class Direction>
void orient(const ManyBands<T>& bands, const C* z, const Direction& axis, BasisSpace<T>& space, C* sh) {
  visit_degrees(bands, axis, space, [&](int l, const T* row) {
    const C factor = detail::times(bands.to_degree(l), z[l]);
    for (int m = -l; m <= l; ++m) sh[sh_index(l, m)] = detail::times(factor, row[m]);
  });
}
template <class C, class T, class Direction>
ManySh<C> orient(const ManyBands<T>& bands, const ManyZh<C>& zh, const Direction& axis) {
  detail::check_enough_bands(zh.bands(), bands.bands(), "orient: a lobe");
  BasisSpace<T> space(bands.bands());
  ManySh<C> sh(bands.bands());
  orient(bands, zh.data(), axis, space, sh.data());
  return sh;
}

/// A function's value in a direction.
template <class C, class T, class Direction>
C reconstruct(const ManyBands<T>& bands, const C* sh, const Direction& direction, BasisSpace<T>& space) {
  C sum = detail::zero<C>(0);
  visit_degrees(bands, direction, space, [&](int l, const T* row) {
    C of_degree = detail::zero<C>(0);
    for (int m = -l; m <= l; ++m) detail::add_times(of_degree, sh[sh_index(l, m)], row[m]);
    sum = sum + of_degree;
  });
  return sum;
}
template <class C, class T, class Direction>
C reconstruct(const ManyBands<T>& bands, const ManySh<C>& sh, const Direction& direction) {
  detail::check_enough_bands(sh.bands(), bands.bands(), "reconstruct: a function");
  BasisSpace<T> space(bands.bands());
  return reconstruct(bands, sh.data(), direction, space);
}

/// Adds a sample to a function's coefficients: `value` times the solid angle that it stands for.
template <class C, class T, class Direction>
void add_sample(const ManyBands<T>& bands, const Direction& direction, const C& value, BasisSpace<T>& space, C* sh) {
  visit_degrees(bands, direction, space, [&](int l, const T* row) {
    for (int m = -l; m <= l; ++m) detail::add_times(sh[sh_index(l, m)], value, row[m]);
  });
}

/// f convolved with a zonal kernel of N coefficients, in place where `to` is f.
template <class C, class T>
void convolve(const ManyBands<T>& bands, const C* f, const T* kernel, C* to) {
  for (int l = 0; l < bands.bands(); ++l) {
    const T factor = bands.to_degree(l) * kernel[l];
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) to[i] = detail::times(f[i], factor);
  }
}
template <class C, class T>
ManySh<C> convolve(const ManyBands<T>& bands, const ManySh<C>& f, const ManyZh<T>& kernel) {
  detail::check_enough_bands(f.bands(), bands.bands(), "convolve: a function");
  detail::check_enough_bands(kernel.bands(), bands.bands(), "convolve: a kernel");
  ManySh<C> r(bands.bands());
  convolve(bands, f.data(), kernel.data(), r.data());
  return r;
}

/// The integral of the product of two functions: the bands that both have.
template <class A, class T>
detail::product_t<A, T> dot(const ManySh<A>& a, const ManySh<T>& b) {
  auto sum = detail::zero<detail::product_t<A, T>>(0);
  for (int i = 0; i < (a.size() < b.size() ? a.size() : b.size()); ++i) sum = sum + detail::times(a[i], b[i]);
  return sum;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
