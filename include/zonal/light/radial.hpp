// Lights that look the same from every side about the direction to their centre: the step that all of them share.
//
// Such a light is a closed form, the factor A_l(d) of each degree at distance d (A_l = sqrt(4 pi / (2l+1)) z_l), then
// oriented: with w the unit vector from the receiver x to the centre,
//
//   L_l^m(x) = A_l(d) Y_l^m(w)                                                                            [1] Eq. 11
//   grad_x L_l^m = (l A_l/d - A_l') w Y_l^m(w) - (2l+1) A_l/d D[Y_(l-1)(w)]
//
// with the step D of basis/ladder.hpp, where [1, Eq. 12-23] differentiates A_l and Y_l^m by angles.
//
// To add a light: 1. write its profile, A_l and A_l', as a function of the distance (sphere.hpp is the sample); 2. give
// it a `center` and a member `profile` that calls it; 3. test it against Dual, as tests/light/ does for each. All
// functions below then take it, and so does add_lights (grid/add_lights.hpp), whatever else it holds: its numbers may
// be of any type, `profile` is asked in the receiver's. A light that is brighter to one side multiplies by a Modulation
// as well (point.hpp: SpotLight). One whose profile grows without bound towards its centre says `static constexpr bool
// is_point = true`. tests/light/added_light.hpp is a whole one.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <limits>
#include <type_traits>
#include <utility>

#include <glm/vec3.hpp>

#include "../basis/gradient.hpp"
#include "../scalar/vector3.hpp"
#include "../transform/orient.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
constexpr long double power_of_two(int exponent) {
  long double power = 1;
  for (; exponent > 0; --exponent) power *= 2;
  for (; exponent < 0; ++exponent) power /= 2;
  return power;
}
}  // namespace detail

/// The factors of each degree, A_l, and their derivatives by the distance, per unit of length.
template <int N, class T>
struct RadialProfile {
  Zh<N, T> value, slope;
};

/// A factor that depends on where the receiver stands, and its gradient by the receiver's position.
template <class T>
struct Modulation {
  T value, gradient[3];
};

/// Where a light's centre is, seen from a receiver: unit direction and distance.
template <class T>
struct Sight {
  T direction[3], distance, inverse_distance;

  /// (x, y, z) leads from the receiver to the centre. A receiver at the very centre has no direction; it is given +z,
  /// and the least distance, where 1/d^3 is finite with a quarter of the exponents to spare: 2.3e-10 in float, 8.6e-78
  /// in double. Coordinates beyond 4.6e18 or 3.3e153, whose squares would not be finite, count as that.
  ZONAL_INLINE static constexpr Sight to(const T& x, const T& y, const T& z) {
    constexpr int exponents = std::numeric_limits<lane_t<T>>::max_exponent;
    constexpr auto greatest = rounded<T>(detail::power_of_two(exponents / 2 - 2));
    constexpr auto least_square = rounded<T>(detail::power_of_two(-exponents / 2));
    const T most = T(greatest), least = T(least_square);
    const T v[3] = {clamp(x, -most, most), clamp(y, -most, most), clamp(z, -most, most)};
    const T square = detail::dot3(v, v);
    const auto is_at_centre = square < least;
    const T distance = sqrt(maximum(square, least)), inverse = T(1) / distance;
    return {{select(is_at_centre, T(0), v[0] * inverse), select(is_at_centre, T(0), v[1] * inverse),
             select(is_at_centre, T(1), v[2] * inverse)},
            distance,
            inverse};
  }
};

/// A light as a receiver sees it.
template <int N, class T>
struct SeenLight {
  Sight<T> sight;
  RadialProfile<N, T> profile;  // without the modulation
  Modulation<T> modulation;     // of a light that has one
};

namespace detail {

// Whether a light has a Modulation.
template <class Light, class T, class = void>
struct ModulationOf {
  static constexpr bool exists = false;
};
template <class Light, class T>
struct ModulationOf<Light, T, std::void_t<decltype(std::declval<Light>().modulation(std::declval<Sight<T>>()))>> {
  static constexpr bool exists = true;
};

template <class Light, class T>
ZONAL_INLINE constexpr Sight<T> sight(const Light& light, const T& x, const T& y, const T& z) {
  return Sight<T>::to(T(light.center[0]) - x, T(light.center[1]) - y, T(light.center[2]) - z);
}

}  // namespace detail

/// L_l^m = A_l Y_l^m(w) to sink(l, m, value).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project_radial(const Zh<N, T>& factors, const Sight<T>& sight, Sink&& sink) {
  evaluate<N>(sight.direction[0], sight.direction[1], sight.direction[2],
              [&](auto l, auto m, const T& y) ZONAL_INLINE { sink(l, m, factors.values[l] * y); });
}

/// The same with the gradient by the receiver's position: sink(l, m, value, d/dx, d/dy, d/dz).
template <int N, class T, class Sink>
ZONAL_DEVICE ZONAL_INLINE constexpr void project_radial_with_gradient(const RadialProfile<N, T>& profile,
                                                                      const Sight<T>& sight, Sink&& sink) {
  const T* w = sight.direction;
  Sh<N, T> basis;
  detail::evaluate_into(basis, w[0], w[1], w[2]);
  unroll<0, N>([&](auto l) ZONAL_INLINE {
    const T factor = profile.value.values[l], by_distance = factor * sight.inverse_distance;
    const T along = T(int{l}) * by_distance - profile.slope.values[l];
    const T along_w[3] = {along * w[0], along * w[1], along * w[2]};
    const detail::DegreeOf<l - 1, T> below{basis.values};
    detail::ladder<l, T, detail::SolidWeights>(
        below, below, [&](auto m, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
          const T& y = basis.values[sh_index(l, m)];
          sink(l, m, factor * y, along_w[0] * y - by_distance * gx, along_w[1] * y - by_distance * gy,
               along_w[2] * y - by_distance * gz);
        });
  });
}

/// What the receiver (x, y, z) sees of a light, in any scalar.
template <int N, class Light, class T>
ZONAL_INLINE constexpr SeenLight<N, T> see(const Light& light, const T& x, const T& y, const T& z) {
  SeenLight<N, T> seen{};
  seen.sight = detail::sight(light, x, y, z);
  seen.profile = light.template profile<N>(seen.sight);
  if constexpr (detail::ModulationOf<Light, T>::exists) seen.modulation = light.modulation(seen.sight);
  return seen;
}

/// A light seen from the receiver (x, y, z), in any scalar: sink(l, m, value).
template <int N, class Light, class T, class Sink>
ZONAL_INLINE constexpr void project(const Light& light, const T& x, const T& y, const T& z, Sink&& sink) {
  SeenLight<N, T> seen = see<N>(light, x, y, z);
  if constexpr (detail::ModulationOf<Light, T>::exists) {
    unroll<0, N>([&](auto l) ZONAL_INLINE {
      seen.profile.value.values[l] = seen.profile.value.values[l] * seen.modulation.value;
    });
  }
  project_radial<N>(seen.profile.value, seen.sight, sink);
}

/// A light that is seen, with its gradient: sink(l, m, value, d/dx, d/dy, d/dz).
template <bool is_modulated, int N, class T, class Sink>
ZONAL_INLINE constexpr void project_seen_with_gradient(const SeenLight<N, T>& seen, Sink&& sink) {
  if constexpr (is_modulated) {
    const Modulation<T>& factor = seen.modulation;
    project_radial_with_gradient<N>(
        seen.profile, seen.sight,
        [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
          sink(l, m, factor.value * value, factor.value * gx + factor.gradient[0] * value,
               factor.value * gy + factor.gradient[1] * value, factor.value * gz + factor.gradient[2] * value);
        });
  } else {
    project_radial_with_gradient<N>(seen.profile, seen.sight, sink);
  }
}

/// The same of a light seen from the receiver (x, y, z).
template <int N, class Light, class T, class Sink>
ZONAL_INLINE constexpr void project_with_gradient(const Light& light, const T& x, const T& y, const T& z, Sink&& sink) {
  project_seen_with_gradient<detail::ModulationOf<Light, T>::exists>(see<N>(light, x, y, z), sink);
}

/// Coefficients at the receiver x, for a light of unit radiance or intensity (each light says which).
template <int N, class Light, class T>
ZONAL_DEVICE Sh<N, T> project(const Light& light, const glm::vec<3, T>& x) {
  Sh<N, T> sh;
  project<N>(light, x[0], x[1], x[2],
             [&](auto l, auto m, const T& value) ZONAL_INLINE { sh.values[sh_index(l, m)] = value; });
  return sh;
}

/// The same, and their gradient by the receiver's position, per unit of length.
template <int N, class Light, class T>
ZONAL_DEVICE ShGradient<N, T> project_with_gradient(const Light& light, const glm::vec<3, T>& x) {
  ShGradient<N, T> sh;
  project_with_gradient<N>(light, x[0], x[1], x[2], detail::into(sh));
  return sh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
