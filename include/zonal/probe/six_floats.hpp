// Six floats: degrees 0 and 1 of luminance, and a chroma, Co and Cg, of the integral. What NRD and Q2RTX keep of a
// pixel or a probe [1, 2]; twelve floats of RGB have three directions, these have one.
//
//   Y = R/4 + G/2 + B/4,  Co = R - B,  Cg = G - (R + B)/2;  R = Y - Cg/2 + Co/2,  G = Y + Cg/2,  B = Y - Cg/2 - Co/2
//
// Here Co and Cg are of the coefficient of degree 0, as Y's is: [1] keeps them without Y_0^0 = 0.282095, and so does
// what [2] reads; [2]'s Co and Cg are half of these. Resolved, all channels have luminance's shape: Co and Cg are
// scaled by what Y is at the normal over what it is on the mean, as in both.
//
// [1] Schied, Panteleev et al., Quake II RTX, spherical harmonics of its denoiser, 2019.
// [2] NVIDIA Real-time Denoisers, NRD.hlsli, NRD_SH_ResolveDiffuse.
#pragma once

#include "channels.hpp"
#include "nonlinear_l1.hpp"
#include "zh3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

template <class T>
struct SixFloats {
  Sh<2, T> luminance;  // Y of radiance, coefficients of degrees 0 and 1
  T co, cg;            // of the coefficient of degree 0
};

/// How luminance is resolved.
enum class SixFloatsShape { linear, nonlinear };

namespace detail {
template <class T>
struct LumaChroma {
  T y, co, cg;
};
template <class T>
ZONAL_INLINE constexpr LumaChroma<T> to_luma_chroma(const T& r, const T& g, const T& b) {
  const T half = T(0.5L) * (r + b);
  return {T(0.5L) * (g + half), r - b, g - half};
}
}  // namespace detail

/// RGB's coefficients, of two bands or more, as six floats: degree 1 keeps its luminance only.
template <int N, class C>
constexpr auto to_six_floats(const Sh<N, C>& radiance) {
  static_assert(N >= 2 && detail::channels_v<C> == 3, "six floats are of RGB on two bands");
  using T = detail::number_t<C>;
  SixFloats<T> six{};
  for (int i = 0; i < 4; ++i) {
    const C& c = radiance[i];
    const auto luma =
        detail::to_luma_chroma(detail::channel_of(c, 0), detail::channel_of(c, 1), detail::channel_of(c, 2));
    six.luminance[i] = luma.y;
    if (i == 0) six.co = luma.co, six.cg = luma.cg;
  }
  return six;
}

/// E / pi at a normal, a unit vector, RGB to sink(channel, value), none negative. The kernel, for any scalar.
template <SixFloatsShape shape = SixFloatsShape::linear, class T, class Direction, class Sink>
ZONAL_INLINE constexpr void irradiance_over_pi(const SixFloats<T>& six, const Direction& normal, Sink&& sink) {
  T y = T(0);
  if constexpr (shape == SixFloatsShape::nonlinear) {
    y = nonlinear_irradiance_over_pi(six.luminance, normal);
  } else {
    y = maximum(reconstruct_convolved(six.luminance, LambertLobe{}, normal), T(0));
  }
  // Co and Cg are of the coefficient: times y over it they are of y.
  const T scale = y / maximum(six.luminance.values[0], T(1e-30L));
  const T co = T(0.5L) * scale * six.co, cg = T(0.5L) * scale * six.cg;
  sink(Index<0>{}, maximum(y - cg + co, T(0)));
  sink(Index<1>{}, maximum(y + cg, T(0)));
  sink(Index<2>{}, maximum(y - cg - co, T(0)));
}

/// The same as a colour.
template <class C, SixFloatsShape shape = SixFloatsShape::linear, class T, class Direction>
constexpr C irradiance_over_pi(const SixFloats<T>& six, const Direction& normal) {
  C colour = detail::zero<C>(0);
  irradiance_over_pi<shape>(six, normal, [&](auto i, const T& value) { detail::channel_of(colour, i) = value; });
  return colour;
}

/// As coefficients: each channel has luminance's shape.
template <class C, class T>
constexpr Sh<2, C> expand(const SixFloats<T>& six) {
  Sh<2, C> r{};
  const T mean = six.luminance[0], co = six.co / T(2), cg = six.cg / T(2);
  const T of_colour[3] = {mean - cg + co, mean + cg, mean - cg - co};
  for (int i = 0; i < 4; ++i) {
    for (int c = 0; c < 3; ++c) {
      const T shape = mean > T(0) ? six.luminance[i] / mean : T(0);
      detail::channel_of(r[i], c) = of_colour[c] * shape;
    }
  }
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
