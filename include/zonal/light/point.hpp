// Lights without extent: point, spot, directional. Their image is a single direction, which no number of bands
// resolves: use them with a convolution, or a window.
#pragma once

#include "radial.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The profile of a point of radiant intensity 1: irradiance 1/d^2 from one direction. At the light's own position it
/// is that of a distance of 1e-15: finite in float.
template <int N, class T>
ZONAL_INLINE constexpr RadialProfile<N, T> point_profile(const Sight<T>& sight) {
  RadialProfile<N, T> profile{};
  const T value = sight.inverse_distance * sight.inverse_distance;
  const T slope = T(-2) * (value * sight.inverse_distance);
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    profile.value.values[l] = value;
    profile.slope.values[l] = slope;
  });
  return profile;
}

/// A point of intensity 1, the same in all directions.
template <class T>
struct PointLight {
  glm::vec<3, T> center;

  template <int N, class R>
  ZONAL_INLINE constexpr RadialProfile<N, R> profile(const Sight<R>& sight) const {
    return point_profile<N>(sight);
  }
};
template <class T>
PointLight(glm::vec<3, T>) -> PointLight<T>;

/// A point that shines into a cone about `axis` (unit, away from the light): intensity 1 up to the angle of
/// cos_inner, 0 from that of cos_outer on, smoothstep of the cosine between. -1 <= cos_outer < cos_inner <= 1.
template <class T>
struct SpotLight {
  glm::vec<3, T> center, axis;
  T cos_inner, cos_outer;

  template <int N, class R>
  ZONAL_INLINE constexpr RadialProfile<N, R> profile(const Sight<R>& sight) const {
    return point_profile<N>(sight);
  }
  template <class R>
  ZONAL_INLINE constexpr Modulation<R> modulation(const Sight<R>& sight) const {
    const R a[3] = {R(axis[0]), R(axis[1]), R(axis[2])};
    const R* w = sight.direction;
    const R cosine = -detail::dot3(sight.direction, a);
    const R inverse_width = R(1) / (R(cos_inner) - R(cos_outer));
    const R t = clamp((cosine - R(cos_outer)) * inverse_width, R(0), R(1));
    const R slope = R(6) * (t * (R(1) - t)) * (inverse_width * sight.inverse_distance);
    return {t * t * (R(3) - (t + t)),
            {slope * (a[0] + cosine * w[0]), slope * (a[1] + cosine * w[1]), slope * (a[2] + cosine * w[2])}};
  }
};
template <class T, class R>
SpotLight(glm::vec<3, T>, glm::vec<3, T>, R, R) -> SpotLight<T>;

/// Irradiance 1 from one direction (unit, towards the light), the same everywhere: its gradient is zero.
template <class T>
struct DirectionalLight {
  glm::vec<3, T> direction;
};

template <int N, class T>
ZONAL_DEVICE Sh<N, T> project(const DirectionalLight<T>& light, const glm::vec<3, T>&) {
  return evaluate<N>(light.direction);
}
template <int N, class T>
ZONAL_DEVICE ShGradient<N, T> project_with_gradient(const DirectionalLight<T>& light, const glm::vec<3, T>&) {
  return {evaluate<N>(light.direction), {}};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
