// How much of a light's sphere stands above the receiver's horizon: the factor H of [1], Eq. 22.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
// [2] Oat and Sander, Ambient aperture lighting, I3D 2007.
#pragma once

#include "../lobe/cap.hpp"
#include "../scalar/math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// none: 1. smoothstep: an approximation. exact: the share of the cap's solid angle.
///
/// The receiver's material holds the clamped cosine, which cuts at the horizon already: what the material makes of the
/// cap is whole with `none` (a diffuse light of 0.5 rad centred on the horizon: 0.999 of the exact light at 21 bands),
/// and the factor of [1] takes of it a second time (0.500). But spheres that stand for a surface reach through it: next
/// to that surface, seen at grazing angles, they give too much, and where every light is taken to be visible the second
/// cut offsets that. So: the factor without visibility, none where rays decide which lights are seen.
enum class Horizon { none, smoothstep, exact };

/// H by smoothstep of the elevation, 0 to 1, within 0.097 of the exact share. [1] Eq. 22 prints the lower bound as a -
/// pi/2 where it is pi/2 - a, and does not clamp; with the elevation h = pi/2 - angle the argument is (1 + h/a)/2,
/// clamped. cos_angle is the cosine between the normal and the cap's axis; the cap is no larger than a hemisphere.
template <class T>
ZONAL_INLINE constexpr T horizon_smoothstep(const SphericalCap<T>& cap, const T& cos_angle) {
  // A point has no extent: it is above or below. The floor keeps 0/0 out and changes no sphere one can see.
  const T sine = maximum(cap.sin_angle, T(1e-18L));
  // Far the most lights are not; what is no number is, whatever stands in the other lanes, and stays none.
  const auto is_on_horizon = T(0) < select(sine <= abs(cos_angle), T(0), T(1));
  if (!AnyLane<T>::of(is_on_horizon)) return select(cos_angle < T(0), T(0), T(1));
  const T inside = clamp(cos_angle, -sine, sine);
  const T elevation = detail::arcsine(abs(inside)) / detail::arcsine(sine);  // of the half angle, 1 at most
  const T x = T(0.5L) + T(0.5L) * select(inside < T(0), -elevation, elevation);
  return x * x * (T(3) - T(2) * x);
}

/// H as the exact share of the cap's solid angle above the horizon, 0 to 1. [2] subtracts angles that are nearly equal
/// for a small cap. Here their difference is one arc sine: with q = sqrt(sin^2 a - cos^2 d),
/// cos B = -cos d cos a / (sin d sin a) and sin B = q / (sin d sin a),
///   H = B / pi + asin(q cos d / (sin d (1 + cos a))) / (pi (1 - cos a)).
template <class T>
ZONAL_INLINE constexpr T horizon_exact(const SphericalCap<T>& cap, const T& cos_angle) {
  const T sin_a = maximum(cap.sin_angle, T(1e-18L)), cos_a = cap.cos_angle;
  const T cos_d = clamp(cos_angle, -sin_a, sin_a);
  const T sin_d = maximum(sqrt((T(1) - cos_d) * (T(1) + cos_d)), T(1e-18L));
  const T q = sqrt((sin_a - cos_d) * (sin_a + cos_d));
  const T b = angle_from(clamp(-cos_d * cos_a / (sin_d * sin_a), T(-1), T(1)), minimum(q / (sin_d * sin_a), T(1)));
  const T slice = asin(clamp(q * cos_d / (sin_d * (T(1) + cos_a)), T(-1), T(1)));
  const T versine = sin_a * (sin_a / (T(1) + cos_a));  // 1 - cos a
  const T share = T(1 / kPi) * (b + slice / maximum(versine, T(1e-36L)));
  return select(cos_angle <= -sin_a, T(0), select(sin_a <= cos_angle, T(1), clamp(share, T(0), T(1))));
}

/// H by the method chosen at compile time.
template <Horizon method, class T>
ZONAL_INLINE constexpr T horizon(const SphericalCap<T>& cap, const T& cos_angle) {
  if constexpr (method == Horizon::smoothstep) return horizon_smoothstep(cap, cos_angle);
  if constexpr (method == Horizon::exact) return horizon_exact(cap, cos_angle);
  return T(1);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
