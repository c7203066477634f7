#pragma once

// A light that the library does not know, added by the guide of light/radial.hpp.

#include <zonal/light/sphere.hpp>
#include <zonal/scalar/math.hpp>

/// A lantern in fog: a sphere whose light falls by e on every `reach`. Neither a template nor made of floats alone.
struct Lantern {
  glm::vec3 center;
  double radius, reach;
  bool is_lit;

  template <int N, class T>
  ZONAL_INLINE constexpr zonal::RadialProfile<N, T> profile(const zonal::Sight<T>& sight) const {
    zonal::RadialProfile<N, T> profile = zonal::sphere_profile<N>(sight, T(radius));
    const T rate = T(1 / reach), fog = is_lit ? zonal::exp(-(sight.distance * rate)) : T(0);
    for (int l = 0; l < N; ++l) {
      T &value = profile.value[l], &slope = profile.slope[l];
      slope = fog * (slope - rate * value);
      value = fog * value;
    }
    return profile;
  }
};
