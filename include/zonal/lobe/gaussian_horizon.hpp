// Spherical Gaussians (SG): their mean directions, and what of them is above a horizon, for any scalar.
//
// Across its axis an SG is nearly a Gaussian of a line. Of that a horizon leaves a normal distribution's integral [2],
// and of a cosine clamped at the horizon the mean is that of max(c + x, 0) [1, 4]:
//
//   s = (1 + erf(t c) / erf(t)) / 2,  f = (c erfc(-t c) + erfc(t)) / 2 + (exp(-t^2 c^2) - exp(-t^2)) / (2 sqrt(pi) t)
//
// with c the cosine between axis and normal. Both go from 0 at c = -1 to 1 at c = 1, and are taken for the way between
// the integrals there, which are known. The steepness t is sqrt(sharpness / 2) for a sharp SG and proportional to the
// sharpness of a blunt one; [1, 2] have a t for either, here one serves both, its three constants fitted to quadrature.
//
// [1] Y. Tokuyoshi, D. Ikeda, P. Kulkarni, T. Harada, Hierarchical Light Sampling with Accurate Spherical Gaussian
//     Lighting, SIGGRAPH Asia 2024.
// [2] Y. Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, SIGGRAPH 2022 Posters.
// [3] A. Banerjee et al., Clustering on the Unit Hypersphere using von Mises-Fisher Distributions, JMLR 6, 2005.
// [4] M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 1964.
#pragma once

#include "../scalar/math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// The length of an SG's mean direction, coth(sharpness) - 1 / sharpness, 0 to 1, for 0 <= sharpness.
template <class T>
ZONAL_INLINE inline T gaussian_mean_length(const T& sharpness) {
  const T blunt = minimum(sharpness, T(1)), sharp = maximum(sharpness, T(1));
  T below = T(1), above = T(13);  // Lambert's continued fraction, x / (3 + x^2 / (5 + ...)), as one quotient
  for (int k = 11; k >= 3; k -= 2) {
    const T next = T(k) * above + blunt * blunt * below;
    below = above;
    above = next;
  }
  const T fall = exp(T(-2) * sharp);
  return select(sharpness < T(1), blunt * below / above, (T(1) + fall) / (T(1) - fall) - T(1) / sharp);
}

/// The sharpness of the SG whose mean direction has that length, in [0, 1): [3] Eq. 4.4, which errs by up to 4 %, and
/// three steps of Newton's. Greatest relative error 1e-5, up to a sharpness of 1e6.
inline double gaussian_sharpness(double mean_length) {
  const double square = mean_length * mean_length;
  double sharpness = mean_length * (3.0 - square) / (1.0 - square);
  for (int step = 0; step < 3 && sharpness > 1e-6; ++step) {
    const double length = gaussian_mean_length(sharpness);
    sharpness += (mean_length - length) / (1.0 - length * length - 2.0 * length / sharpness);
  }
  return sharpness;
}

/// erfc(x), and exp(-x^2). Greatest error 2e-7 [4, 7.1.26].
template <class T>
struct GaussianTail {
  T integral, density;
};
template <class T>
ZONAL_INLINE inline GaussianTail<T> gaussian_tail(const T& x) {
  const T density = exp(-x * x), u = T(1) / (T(1) + T(0.3275911L) * abs(x));
  const T polynomial =
      u *
      (T(0.254829592L) + u * (T(-0.284496736L) + u * (T(1.421413741L) + u * (T(-1.453152027L) + u * T(1.061405429L)))));
  const T beyond = polynomial * density;
  return {select(x < T(0), T(2) - beyond, beyond), density};
}

/// Of an SG's integral over the sphere, what is above a horizon, and the integral of its product with the cosine there.
template <class T>
struct GaussianAboveHorizon {
  T share, cosine;
  /// The mean cosine of what is above, in [0, 1].
  ZONAL_INLINE T mean_cosine() const { return minimum(cosine / maximum(share, T(1e-6L)), T(1)); }
};

/// The cosine is that between the SG's axis and the normal; 0 <= sharpness. Greatest errors, of the whole: of the
/// cosine's integral 0.0023 (sharpness 4), of the share 0.009 (sharpness 8); both exact for an axis on the normal.
template <class T>
ZONAL_INLINE inline GaussianAboveHorizon<T> gaussian_above_horizon(const T& cosine, const T& sharpness) {
  const T c = clamp(cosine, T(-1), T(1)), lambda = maximum(sharpness, T(1e-6L));
  const T t = lambda * sqrt((T(0.5L) * lambda + T(0.532L)) / ((lambda + T(1.357L)) * lambda + T(8.57L)));
  const GaussianTail<T> at_axis = gaussian_tail(-t * c), at_end = gaussian_tail(t);
  constexpr long double inverse_root_pi = 0.564189583547756286948079451560772586L;
  const T share = T(0.5L) + T(0.5L) * ((at_axis.integral - T(1)) / maximum(T(1) - at_end.integral, T(1e-6L)));
  const T way = T(0.5L) * (c * at_axis.integral + at_end.integral) +
                T(0.5L * inverse_root_pi) * (at_axis.density - at_end.density) / t;

  // Of an SG about the normal e^-lambda times what is above is below, and its mean height is `above`.
  const T fall = exp(-lambda), above = T(0.5L) + T(0.5L) * gaussian_mean_length(T(0.5L) * lambda);
  const T low = fall * (T(1) - above), whole = T(1) + fall;
  return {(fall + (T(1) - fall) * clamp(share, T(0), T(1))) / whole,
          (low + (above - low) * clamp(way, T(0), T(1))) / whole};
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
