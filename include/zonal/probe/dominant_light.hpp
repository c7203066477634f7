// The one light, and the ambient light, that a probe is most like; and a light taken out of a probe [1].
//
// The direction is that in which degree 1 of luminance is greatest. A light there of irradiance E (on what faces it)
// has the coefficients E Y_l^m(d), ambient light of radiance a has 2 sqrt(pi) a in degree 0 alone. E, and a, are least
// squares, of irradiance or of radiance:
//
//   with ambient light     E = sum_{l>=1} w_l f_l.Y_l(d) / sum_{l>=1} w_l (2l+1)/4pi,  a = (f_0 - E Y_0) / (2 sqrt(pi))
//   without                the same sums from l = 0 on, a = 0
//
// w_l = 1 of radiance; of irradiance the squares of 1, 2/3, 1/4, ... At three bands that is [1]'s: its light of
// 16 pi/17 (the light by which three bands' irradiance is 1 at most) and its factor 867/(316 pi).
//
// [1] Sloan, Stupid spherical harmonics tricks, GDC 2008.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../environment/irradiance.hpp"
#include "channels.hpp"
#include "least_value.hpp"
#include "zh3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What the least squares are of, and what must not become negative.
enum class LightFit { irradiance, radiance };

template <class C>
struct DominantLight {
  std::array<detail::number_t<C>, 3> direction;  // unit, towards the light; z where there is none
  C irradiance;                                  // of what faces it; not negative
  C ambient;                                     // radiance from everywhere; 0 where none was asked for
};

namespace detail {
// Degree by degree, what the light's coefficients are multiplied by: f.Y_l(d), and the square of what is fitted.
template <LightFit fit, int l>
constexpr double light_weight() {
  constexpr auto factor = static_cast<double>(2 * cosine_integral(l));
  return fit == LightFit::radiance ? 1.0 : factor * factor;
}

template <LightFit fit, int N, class T>
ZONAL_INLINE constexpr T light_along(const Sh<N, T>& sh, const T (&d)[3], bool has_ambient) {
  T sum = T(0);
  double all = 0;
  evaluate<N>(d[0], d[1], d[2], [&](auto l, auto m, const T& y) ZONAL_INLINE {
    if (l > 0 || !has_ambient) sum = sum + T(light_weight<fit, l>()) * sh.values[sh_index(l, m)] * y;
  });
  unroll<0, N>([&](auto l) {
    if (l > 0 || !has_ambient) all += light_weight<fit, l>() * (2 * l + 1) / (4 * double(kPi));
  });
  return maximum(sum / T(all), T(0));
}
}  // namespace detail

/// The light, and ambient light if asked for, that are nearest to a probe's radiance, of numbers or colours, on at
/// least two bands.
template <LightFit fit = LightFit::irradiance, int N, class C>
DominantLight<C> dominant_light(const Sh<N, C>& radiance, bool has_ambient = true) {
  static_assert(N >= 2, "a direction needs two bands");
  using T = detail::number_t<C>;
  T axis[3] = {};
  detail::zh3_axis(with_bands<2>(radiance), Zh3Axis::luminance, 0, axis);
  DominantLight<C> light{{axis[0], axis[1], axis[2]}, detail::zero<C>(0), detail::zero<C>(0)};
  for (int c = 0; c < detail::channels_v<C>; ++c) {
    const T irradiance = detail::light_along<fit>(detail::take_channel<T>(radiance, c), axis, has_ambient);
    detail::channel_of(light.irradiance, c) = irradiance;
    if (has_ambient) {
      constexpr auto y0 = rounded<T>(detail::zonal_normalisation<0>);
      detail::channel_of(light.ambient, c) = (detail::channel_of(radiance[0], c) - irradiance * T(y0)) * T(y0);
    }
  }
  return light;
}

/// The coefficients of radiance of a light without size, and of ambient light.
template <int N, class C>
Sh<N, C> project(const DominantLight<C>& light) {
  using T = detail::number_t<C>;
  Sh<N, C> sh = evaluate<N>(light.direction) * light.irradiance;
  constexpr auto ambient = rounded<T>(1 / detail::zonal_normalisation<0>);
  sh.values[0] = sh.values[0] + detail::times(light.ambient, T(ambient));
  return sh;
}

template <int N, class C>
struct ExtractedLight {
  DominantLight<C> light;  // without ambient light, which stays in the rest
  Sh<N, C> rest;           // radiance: what was given, less the light
  double share;            // of the fitted light, 0 to 1: what could be taken
};

/// The light of dominant_light, taken out of a probe. With `keeps_sign`, only such a share of it, one for all channels,
/// that no channel of the rest is negative anywhere (`positive`: its irradiance, or its radiance): proved by
/// least_value.hpp. Of a probe that is negative somewhere already none is taken: use dering first.
template <LightFit fit = LightFit::irradiance, int N, class C>
ExtractedLight<N, C> extract_light(const Sh<N, C>& radiance, bool keeps_sign = true,
                                   LightFit positive = LightFit::irradiance) {
  using T = detail::number_t<C>;
  constexpr int count = detail::channels_v<C>;
  DominantLight<C> light = dominant_light<fit>(radiance);
  light.ambient = detail::zero<C>(0);
  double share = 1;
  for (bool is_done = !keeps_sign; !is_done && share > 0;) {
    is_done = true;
    for (int c = 0; c < count && share > 0; ++c) {
      const std::array<double, 3> d{double(light.direction[0]), double(light.direction[1]), double(light.direction[2])};
      const auto seen = [&](const Sh<N, double>& f) {
        return positive == LightFit::irradiance ? irradiance_over_pi(f) : f;
      };
      const Sh<N, double> before = seen(detail::take_channel<double>(radiance, c));
      const Sh<N, double> taken = seen(evaluate<N>(d) * double(detail::channel_of(light.irradiance, c)));
      const double scale = detail::sum_of_degrees(before);
      const double enough = 2 * double(std::numeric_limits<T>::epsilon()) * scale;
      const LeastValue least = detail::least_value(before - taken * share, enough, enough / 4);
      if (least.bound >= 0) continue;
      // In this direction the share is too large, but for what is lacking without any light.
      is_done = false;
      const double there = reconstruct(before, least.direction), less = reconstruct(taken, least.direction);
      const double most = (there - 2 * enough) / less;
      share = less > 0 && there > 2 * enough ? (std::min)(most, share * (1 - 1e-6)) : 0;
    }
  }
  for (int c = 0; c < count; ++c) detail::channel_of(light.irradiance, c) *= static_cast<T>(share);
  return {light, radiance - project<N>(light), share};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
