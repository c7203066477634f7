// The sum of many coloured lights at a receiver, or a packet of them: coefficients and gradients, RGB.
//
// The gradient of L_l^m is U[p_l Y_(l+1)] + D[q_l Y_(l-1)], with U and D linear and the same for all lights
// (light/radial.hpp). So p_l Y_(l+1) and q_l Y_(l-1) are summed over the lights, and U and D applied once, at the end:
// per light and colour 6 l + 3 multiplications for degree l, instead of 8 l + 4 and the gradient itself.
#pragma once

#include <glm/vec3.hpp>

#include "../light/radial.hpp"
#include "../scalar/packet.hpp"

namespace zonal {

/// A light of radiance or intensity 1 (the light says which) times an RGB colour.
template <class Light>
struct ColouredLight {
  Light light;
  glm::vec3 colour;
};

/// The sums at receivers T (a float, or a packet of them). Wide takes several lights at once: T, or a packet of a
/// multiple of T's lanes, whose first lanes are the receivers for the first light, and so on. That loads and stores
/// each sum once for all of them.
template <int N, class T, class Wide = T>
class LightSums {
 public:
  LightSums() {
    for (Sums& sums : sums_) {
      for (int c = 0; c < 3; ++c) sums.value[c] = sums.up[c] = sums.down[c] = T(0);
    }
  }

  /// Adds lights seen from (x, y, z).
  template <class Light>
  ZONAL_INLINE void add(const Light& light, const Wide (&colour)[3], const Wide& x, const Wide& y, const Wide& z) {
    static_assert(!detail::ModulationOf<Light, Wide>::exists, "a modulated light is not radial");
    const Sight<Wide> sight = detail::sight(light, x, y, z);
    const RadialProfile<N, Wide> profile = light.template profile<N>(sight);
    Sh<N + 1, Wide> basis;
    detail::evaluate_into(basis, sight.direction[0], sight.direction[1], sight.direction[2]);

    // Degree by degree, so that the nine factors stay in registers.
    unroll<0, N + 1>([&](auto l) ZONAL_INLINE {
      Wide value[3], up[3], down[3];
      if constexpr (l < N) {
        for (int c = 0; c < 3; ++c) value[c] = profile.value.values[l] * colour[c];
      }
      if constexpr (l > 0) {
        const Wide over_distance = profile.value.values[l - 1] * sight.inverse_distance;
        const Wide step = detail::step_up(l - 1, over_distance, profile.slope.values[l - 1]);
        for (int c = 0; c < 3; ++c) up[c] = step * colour[c];
      }
      if constexpr (l + 1 < N) {
        const Wide over_distance = profile.value.values[l + 1] * sight.inverse_distance;
        const Wide step = detail::step_down(l + 1, over_distance, profile.slope.values[l + 1]);
        for (int c = 0; c < 3; ++c) down[c] = step * colour[c];
      }
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        for (int c = 0; c < 3; ++c) {
          if constexpr (l < N) add_product(sums_[i].value[c], value[c], basis.values[i]);
          if constexpr (l > 0) add_product(sums_[i].up[c], up[c], basis.values[i]);
          if constexpr (l + 1 < N) add_product(sums_[i].down[c], down[c], basis.values[i]);
        }
      }
    });
  }

  /// visit(l, m, value, up, down), RGB arrays of three: what Y_l^m is multiplied by, for l up to N. `value` and `down`
  /// stay 0 where there is no such degree: for l = N, and from l = N-1 on.
  template <class Visit>
  void for_each(Visit&& visit) {
    unroll<0, N + 1>([&](auto l) {
      for (int m = -l; m <= l; ++m) {
        Sums& sums = sums_[sh_index(l, m)];
        visit(l, m, sums.value, sums.up, sums.down);
      }
    });
  }

  /// The results: sink(l, m, colour, value, d/dx, d/dy, d/dz), colour 0 to 2.
  template <class Sink>
  void finish(Sink&& sink) const {
    for (int c = 0; c < 3; ++c) {
      unroll<0, N>([&](auto l) {
        detail::ladder<l, T, detail::UnitWeights>([&](auto m) { return sums_[sh_index(l + 1, m)].up[c]; },
                                                  [&](auto m) { return sums_[sh_index(l - 1, m)].down[c]; },
                                                  [&](auto m, const T& x, const T& y, const T& z) {
                                                    sink(l, m, c, sums_[sh_index(l, m)].value[c], x, y, z);
                                                  });
      });
    }
  }

 private:
  // What Y_l^m is multiplied by: A_l, the step up from l-1, and the step down from l+1.
  struct Sums {
    T value[3], up[3], down[3];
  };
  Sums sums_[static_cast<std::size_t>((N + 1) * (N + 1))];
};

}  // namespace zonal
