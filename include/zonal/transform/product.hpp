// Products of functions: the coefficients of a(w) b(w) from those of a and b.
//
// (a b)_j = sum over i, k of G_ijk a_i b_k, G_ijk being the integral of three harmonics (gaunt.hpp). A product of N
// bands by N bands has 2N - 1. Coefficients may be colours: of colours by numbers, or by colours, each channel for
// itself, where these can be multiplied. The unit of a product is that of a times that of b.
//
// Greatest error, of 1 to 13 bands, in units of the norm (root of the sum of squares) of the whole product: 3e-7 in
// float, 5e-16 in double. clang++ computes the tables of up to 40 bands within its limits, g++ of 64.
#pragma once

#include "dot.hpp"
#include "product_by_gaunt.hpp"
#include "product_by_rings.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Measured, in packets and one by one, truncated and whole: from 6 bands on rings take less time, and far less to
// compile.
inline constexpr int most_gaunt_bands = 5;

template <int K, int N, class A, class B>
ZONAL_INLINE constexpr Sh<K, product_t<A, B>> product(const Sh<N, A>& a, const Sh<N, B>& b) {
  if constexpr (N <= most_gaunt_bands) {
    return product_by_gaunt<K>(a, b);
  } else {
    return product_by_rings<K>(a, b);
  }
}
// A zonal factor has few coefficients: its matrices are short to write out.
inline constexpr int most_zonal_gaunt_bands = 10;
}  // namespace detail

/// The first N bands of the product, as if it were projected on them: what the bands beyond hold is lost.
template <int N, class A, class B>
ZONAL_DEVICE constexpr Sh<N, detail::product_t<A, B>> product(const Sh<N, A>& a, const Sh<N, B>& b) {
  return detail::product<N>(a, b);
}

/// The whole product, in all of its 2N - 1 bands: in every direction its value is that of a times that of b.
template <int N, class A, class B>
ZONAL_DEVICE constexpr Sh<2 * N - 1, detail::product_t<A, B>> full_product(const Sh<N, A>& a, const Sh<N, B>& b) {
  return detail::product<2 * N - 1>(a, b);
}

/// The first N bands of the product with a function that is zonal about z: it keeps every order, and takes far less
/// than the product with an Sh.
template <int N, class A, class B>
ZONAL_DEVICE constexpr Sh<N, detail::product_t<A, B>> product(const Sh<N, A>& a, const Zh<N, B>& b) {
  if constexpr (N <= detail::most_zonal_gaunt_bands) {
    return detail::product_by_gaunt(a, b);
  } else {
    return detail::product_by_rings(a, b);
  }
}
/// The first N bands of the product of two functions that are zonal about one axis, which is zonal about it.
template <int N, class A, class B>
ZONAL_DEVICE constexpr Zh<N, detail::product_t<A, B>> product(const Zh<N, A>& a, const Zh<N, B>& b) {
  return detail::product_by_gaunt(a, b);
}

/// The integral over the sphere of a b c: exact, for what the product loses beyond N bands c does not have.
template <int N, class A, class B, class C>
ZONAL_DEVICE constexpr auto triple_product(const Sh<N, A>& a, const Sh<N, B>& b, const Sh<N, C>& c) {
  return dot(product(a, b), c);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
