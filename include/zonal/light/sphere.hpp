// Sphere lights: with a sharp edge, and with a soft one.
//
// From outside, distance d > radius r, the sphere is a cap of half angle asin(r/d), and da/dd = -tan a / d.
// - On the surface the slope A_l' is infinite for even l. What comes back is the slope where cos a = sqrt(epsilon)/2,
//   just outside: finite, and larger than at any representable distance beyond.
// - Inside, the light is a hemisphere about the direction to the centre: continuous with the surface. The slope is 0,
//   and the gradient is that of the direction alone.
// - At the centre there is no direction: the hemisphere about +z. The gradient is meaningless, but finite.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <limits>

#include "../lobe/cap.hpp"
#include "radial.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The profile of a sphere of radiance 1 [1, Eq. 9, 14-16]. With the constants of the cap and of the orientation
/// together, A_l = pi sin^2 a e_l and A_l' = -2 pi sin^2 a / (d cos a) P_l(cos a).
template <int N, class T>
ZONAL_INLINE constexpr RadialProfile<N, T> sphere_profile(const Sight<T>& sight, const T& radius) {
  const auto cap = SphericalCap<T>::from_sphere(sight.distance, sight.inverse_distance, radius);
  constexpr auto least_cosine =
      rounded<T>(constexpr_sqrt(static_cast<long double>(std::numeric_limits<lane_t<T>>::epsilon())) / 2);
  constexpr auto pi = rounded<T>(kPi), minus_two_pi = rounded<T>(-2 * kPi);
  const T tangent = cap.sin_angle / maximum(cap.cos_angle, T(least_cosine));
  const T slope =
      select(sight.distance < radius, T(0), T(minus_two_pi) * (cap.sin_angle * tangent * sight.inverse_distance));
  RadialProfile<N, T> profile{};
  detail::cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE { profile.value.values[l] = T(pi) * sum; });
  detail::cap_legendre<N>(cap,
                          [&](auto l, const T& legendre) ZONAL_INLINE { profile.slope.values[l] = slope * legendre; });
  return profile;
}

/// A sphere of radiance 1. center and radius >= 0 in units of length.
template <class T>
struct SphereLight {
  glm::vec<3, T> center;
  T radius;

  template <int N, class R>
  ZONAL_INLINE constexpr RadialProfile<N, R> profile(const Sight<R>& sight) const {
    return sphere_profile<N>(sight, R(radius));
  }
};
template <class T, class R>
SphereLight(glm::vec<3, T>, R) -> SphereLight<T>;

/// A sphere whose image is blurred by a zonal kernel (a lobe that integrates to 1): radiance 1 in the middle, a soft
/// edge as wide as the kernel, the same at every distance. One multiplication per degree more than a sphere.
template <int N, class T>
struct SoftSphereLight {
  glm::vec<3, T> center;
  T radius;
  Zh<N, T> kernel;

  template <int Bands, class R>
  ZONAL_INLINE constexpr RadialProfile<Bands, R> profile(const Sight<R>& sight) const {
    static_assert(Bands <= N, "the kernel has fewer bands than asked for");
    RadialProfile<Bands, R> profile = sphere_profile<Bands>(sight, R(radius));
    unroll<0, Bands>([&](auto l) ZONAL_INLINE {
      constexpr auto to_degree = rounded<R>(detail::zonal_to_degree<l>);
      const R factor = R(to_degree) * R(kernel.values[l]);
      profile.value.values[l] = profile.value.values[l] * factor;
      profile.slope.values[l] = profile.slope.values[l] * factor;
    });
    return profile;
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
