// What is known of a function on the sphere, and which of its coefficients are there for it.
#pragma once

#include "sh.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// zonal: the same all about the z axis, coefficients of m = 0 alone (Zh); mirror: even in phi, of m >= 0 alone
/// (EvenSh); none: all of them (Sh).
enum class Symmetry { zonal, mirror, none };

/// Whether the coefficient of order m can be other than zero.
constexpr bool has_order(Symmetry symmetry, int m) {
  return symmetry == Symmetry::none || m == 0 || (symmetry == Symmetry::mirror && m > 0);
}

/// How many coefficients so many bands have.
constexpr int coefficient_count(Symmetry symmetry, int bands) {
  return symmetry == Symmetry::zonal    ? bands
         : symmetry == Symmetry::mirror ? even_index(bands, 0)
                                        : sh_index(bands, -bands);
}

/// Where the one of degree l and order m stands, which is one of has_order.
constexpr int coefficient_index(Symmetry symmetry, int l, int m) {
  return symmetry == Symmetry::zonal ? l : symmetry == Symmetry::mirror ? even_index(l, m) : sh_index(l, m);
}

/// The symmetry of a type of coefficients.
template <class Coefficients>
inline constexpr Symmetry symmetry_of = Coefficients::symmetry;
template <int N, class T>
inline constexpr Symmetry symmetry_of<Zh<N, T>> = Symmetry::zonal;
template <int N, class T>
inline constexpr Symmetry symmetry_of<EvenSh<N, T>> = Symmetry::mirror;
template <int N, class T>
inline constexpr Symmetry symmetry_of<Sh<N, T>> = Symmetry::none;

/// The mean of a function about the z axis: its coefficients of m = 0.
template <int N, class T>
constexpr Zh<N, T> about_axis(const EvenSh<N, T>& even) {
  Zh<N, T> zonal{};
  for (int l = 0; l < N; ++l) zonal.values[l] = even(l, 0);
  return zonal;
}
template <int N, class T>
constexpr Zh<N, T> about_axis(const Sh<N, T>& sh) {
  Zh<N, T> zonal{};
  for (int l = 0; l < N; ++l) zonal.values[l] = sh(l, 0);
  return zonal;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
