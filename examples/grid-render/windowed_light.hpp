#pragma once

// A sphere light in two parts that add up to it: what is far goes into a grid, what is near to each point by itself.

#include <zonal/light/sphere.hpp>

namespace example::grid_render {

/// Up to which distance from a sphere's surface it is near alone, and from which far alone; between them the one goes
/// over into the other by a smooth step. No length at all: it is far everywhere.
struct NearRange {
  float from = 0.0f, to = 0.0f;

  bool is_empty() const { return !(to > 0.0f); }
};

/// The light times the step, 0 up to `start`, or times what it leaves.
template <int N, class T>
ZONAL_INLINE constexpr zonal::RadialProfile<N, T> windowed(zonal::RadialProfile<N, T> profile, const T& distance,
                                                           const T& start, const T& inverse_length, bool is_far) {
  const T t = zonal::clamp((distance - start) * inverse_length, T(0), T(1)), rest = T(1) - t;
  const T step = t * t * t * (T(10) + t * (T(6) * t - T(15))), slope = T(30) * t * t * rest * rest * inverse_length;
  const T factor = is_far ? step : T(1) - step, by_distance = is_far ? slope : -slope;
  for (int l = 0; l < N; ++l) {
    profile.slope.values[l] = profile.slope.values[l] * factor + profile.value.values[l] * by_distance;
    profile.value.values[l] = profile.value.values[l] * factor;
  }
  return profile;
}

template <class T>
struct FarSphere {
  glm::vec<3, T> center;
  T radius, start, inverse_length;

  template <int N, class R>
  ZONAL_INLINE constexpr zonal::RadialProfile<N, R> profile(const zonal::Sight<R>& sight) const {
    return windowed(zonal::sphere_profile<N>(sight, R(radius)), sight.distance, R(start), R(inverse_length), true);
  }
};

template <class T>
struct NearSphere {
  glm::vec<3, T> center;
  T radius, start, inverse_length;

  template <int N, class R>
  ZONAL_INLINE constexpr zonal::RadialProfile<N, R> profile(const zonal::Sight<R>& sight) const {
    return windowed(zonal::sphere_profile<N>(sight, R(radius)), sight.distance, R(start), R(inverse_length), false);
  }
};

/// A part of a sphere light. Where it is far everywhere the step is over before it begins.
template <template <class> class Part>
Part<float> part_of(const zonal::SphereLight<float>& light, const NearRange& range) {
  constexpr float at_once = 1e30f;
  if (range.is_empty()) return {light.center, light.radius, 0.0f, at_once};
  return {light.center, light.radius, light.radius + range.from, 1.0f / (range.to - range.from)};
}

}  // namespace example::grid_render
