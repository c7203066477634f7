// Zonal lobes of many bands: the steps of lobe/, in loops. The coefficients go to N numbers of the caller's, or are
// kept.
#pragma once

#include "../lobe/cap.hpp"
#include "../lobe/lambert.hpp"
#include "../lobe/phong.hpp"
#include "../lobe/spherical_gaussian.hpp"
#include "coefficients.hpp"
#include "many_bands.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The cap's indicator: 1 inside, 0 outside.
template <class T>
void project(const ManyBands<T>& bands, const SphericalCap<T>& cap, T* z) {
  detail::CapSums<T> sums(cap, T(detail::narrow_cap_cosine(bands.bands())));
  z[0] = bands.integral(0) / T(2) * sums.zeroth;
  for (int l = 1; l < bands.bands(); ++l) {
    if (l > 1) sums.add(detail::next_difference(bands.of_step(l, 1), bands.of_sum(l, 1), sums.t, sums.e, sums.d));
    z[l] = bands.integral(l) / T(2) * (l % 2 == 1 ? sums.e : sums.even_sign * sums.e);
  }
}

namespace detail {
// P_l(1 - t), and with a negative sign P_l(t - 1), to sink(l, value).
template <class T, class Sink>
void visit_legendre(const ManyBands<T>& bands, T t, bool is_negative, const Sink& sink) {
  T legendre = T(1), step = T(0);
  for (int l = 0; l < bands.bands(); ++l) {
    if (l > 0) {
      step = next_difference(bands.of_step(l, 0), bands.of_sum(l, 0), t, legendre, step);
      legendre = legendre + step;
    }
    sink(l, is_negative && l % 2 == 1 ? -legendre : legendre);
  }
}
}  // namespace detail

/// Its derivative by the half angle, per radian.
template <class T>
void project_derivative(const ManyBands<T>& bands, const SphericalCap<T>& cap, T* z) {
  detail::visit_legendre(bands, detail::versine(cap), cap.cos_angle < T(0),
                         [&](int l, T legendre) { z[l] = bands.integral(l) * (cap.sin_angle * legendre); });
}

/// Y_l^0 at cos_angle from the axis, -1 to 1.
template <class T>
void evaluate_zonal(const ManyBands<T>& bands, T cos_angle, T* z) {
  detail::visit_legendre(bands, T(1) - abs(cos_angle), cos_angle < T(0),
                         [&](int l, T legendre) { z[l] = bands.normalisation(l) * legendre; });
}

/// The clamped cosine over pi.
template <class T>
void project(const ManyBands<T>& bands, LambertLobe, T* z) {
  long double integral[2] = {};
  for (int l = 0; l < bands.bands(); ++l) {
    integral[l % 2] = detail::next_cosine_integral(l, integral[l % 2]);
    z[l] = T(2 * detail::zonal_normalisation_of(l) * integral[l % 2]);
  }
}

/// The cosine power, of an exponent n >= 0.
template <class T>
void project(const ManyBands<T>& bands, const PhongLobe<T>& lobe, T* z) {
  const T n = lobe.exponent;
  T integral[2] = {T(1), (n + T(1)) / (n + T(2))};  // (n+1) I_l
  for (int l = 0; l < bands.bands(); ++l) {
    if (l >= 2) integral[l % 2] = integral[l % 2] * detail::phong_ratio(n, l);
    z[l] = bands.normalisation(l) * integral[l % 2];
  }
}

/// The spherical Gaussian, of a sharpness >= 0.
template <class T>
void project(const ManyBands<T>& bands, const SphericalGaussian<T>& lobe, T* z) {
  constexpr auto scale = rounded<T>(4 * kPi);
  const T sum = detail::gaussian_ratios(lobe.sharpness, bands.bands(), z);  // which z keeps until it has the values
  detail::GaussianIntegrals<T> integrals(lobe.sharpness, sum, bands.bands());
  z[0] = scale * bands.normalisation(0) * integrals.i0;
  for (int l = 1; l < bands.bands(); ++l) z[l] = scale * bands.normalisation(l) * integrals.next(l, z[l]);
}

/// The coefficients of any of these lobes, kept.
template <class T, class Lobe>
ManyZh<T> project(const ManyBands<T>& bands, const Lobe& lobe) {
  ManyZh<T> zh(bands.bands());
  project(bands, lobe, zh.data());
  return zh;
}
template <class T>
ManyZh<T> project_derivative(const ManyBands<T>& bands, const SphericalCap<T>& cap) {
  ManyZh<T> zh(bands.bands());
  project_derivative(bands, cap, zh.data());
  return zh;
}
template <class T>
ManyZh<T> evaluate_zonal(const ManyBands<T>& bands, T cos_angle) {
  ManyZh<T> zh(bands.bands());
  evaluate_zonal(bands, cos_angle, zh.data());
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
