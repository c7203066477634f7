// The sum of many coloured lights at a receiver, or a packet of them: coefficients and gradients, RGB.
//
// The gradient of L_l^m = A_l(d) Y_l^m by the receiver's position is U[p_l Y_(l+1)] + D[q_l Y_(l-1)], with
// p_l = l A_l/d - A_l', q_l = -(l+1) A_l/d - A_l', and U and D linear and the same for all lights (basis/ladder.hpp).
// So p_l Y_(l+1) and q_l Y_(l-1) are summed over the lights, and U and D applied once, at the end: per light and colour
// 6 l + 3 multiplications for degree l, instead of 8 l + 4 and the gradient itself.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "../light/radial.hpp"
#include "../scalar/packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A light of radiance or intensity 1 (the light says which) times an RGB colour.
template <class Light>
struct ColouredLight {
  Light light;
  glm::vec3 colour;
};

/// The sums at receivers T (a float, or a packet of them). Wide takes several lights at once: T, or a packet of a
/// multiple of T's lanes, whose first lanes are the receivers for the first light, and so on. That loads and stores
/// each sum once for all of them. Lights with a Modulation need is_modulated, and twice as many sums. Without gradients
/// there are values alone, a third of the sums.
template <int N, class T, class Wide = T, bool is_modulated = false, bool has_gradients = true>
class LightSums {
 public:
  LightSums() {
    for_each_sum([](T& sum) { sum = T(0); });
  }

  /// Adds lights seen from (x, y, z).
  template <class Light>
  ZONAL_INLINE void add(const Light& light, const Wide (&colour)[3], const Wide& x, const Wide& y, const Wide& z) {
    static_assert(detail::ModulationOf<Light, Wide>::exists == is_modulated, "a modulated light needs is_modulated");
    add(see<N>(light, x, y, z), colour);
  }

  /// Adds lights as they are seen.
  ZONAL_INLINE void add(const SeenLight<N, Wide>& seen, const Wide (&colour)[3]) {
    const Sight<Wide>& sight = seen.sight;
    RadialProfile<N, Wide> profile = seen.profile;
    if constexpr (is_modulated) {
      unroll<0, N>([&](auto l) ZONAL_INLINE {
        profile.value.values[l] = profile.value.values[l] * seen.modulation.value;
        profile.slope.values[l] = profile.slope.values[l] * seen.modulation.value;
      });
    }
    Sh<degrees, Wide> basis;
    detail::evaluate_into(basis, sight.direction[0], sight.direction[1], sight.direction[2]);

    // Degree by degree, so that its factors stay near.
    unroll<0, degrees>([&](auto l) ZONAL_INLINE {
      const auto& values = profile.value.values;
      const auto& slopes = profile.slope.values;
      Wide factor[static_cast<std::size_t>(term_count)][3];
      const auto set = [&](int term, const Wide& x_of_degree) ZONAL_INLINE {
        for (int c = 0; c < 3; ++c) factor[term][c] = x_of_degree * colour[c];
      };
      if constexpr (exists(value, l)) set(value, values[l]);
      if constexpr (exists(up, l)) set(up, Wide(l - 1) * (values[l - 1] * sight.inverse_distance) - slopes[l - 1]);
      if constexpr (exists(down, l)) {
        set(down, -(Wide(l + 2) * (values[l + 1] * sight.inverse_distance)) - slopes[l + 1]);
      }
      if constexpr (exists(modulated, l)) {  // (w A_l Y)' = w (A_l Y)' + w' A_l Y
        for (int k = 0; k < 3; ++k) set(modulated + k, seen.profile.value.values[l] * seen.modulation.gradient[k]);
      }
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
        for (int c = 0; c < 3; ++c) {
          unroll<0, term_count>([&](auto term) ZONAL_INLINE {
            if constexpr (exists(term, l)) add_product(sums_[i][c][term], factor[term][c], basis.values[i]);
          });
        }
      }
    });
  }

  /// visit(sum) for each number that is summed up, for LongSums.
  template <class Visit>
  void for_each_sum(const Visit& visit) {
    for (Sums& sums : sums_) {
      for (auto& channel : sums) {
        for (T& sum : channel) visit(sum);
      }
    }
  }

  /// visit(l, m, colour, value, up, down): what Y_l^m is multiplied by, for l up to N. `value` and `down` stay 0 where
  /// there is no such degree: for l = N, and from l = N-1 on.
  template <class Visit>
  void for_each(Visit&& visit) {
    static_assert(has_gradients, "these are the sums of values alone");
    for (int l = 0; l <= N; ++l) {
      for (int m = -l; m <= l; ++m) {
        for (int c = 0; c < 3; ++c) {
          T* const sums = sums_[sh_index(l, m)][c];
          visit(l, m, c, sums[value], sums[up], sums[down]);
        }
      }
    }
  }

  /// The results: sink(l, m, colour, value, d/dx, d/dy, d/dz), colour 0 to 2; without gradients sink(l, m, colour,
  /// value).
  template <class Sink>
  void finish(Sink&& sink) const {
    for (int c = 0; c < 3; ++c) {
      const auto sum = [&](int l, int m, int term) -> const T& { return sums_[sh_index(l, m)][c][term]; };
      unroll<0, N>([&](auto l) {
        if constexpr (has_gradients) {
          detail::ladder<l, T, detail::UnitWeights>(
              [&](auto m) { return sum(l + 1, m, up); }, [&](auto m) { return sum(l - 1, m, down); },
              [&](auto m, const T& x, const T& y, const T& z) {
                if constexpr (is_modulated) {
                  sink(l, m, c, sum(l, m, value), x + sum(l, m, modulated), y + sum(l, m, modulated + 1),
                       z + sum(l, m, modulated + 2));
                } else {
                  sink(l, m, c, sum(l, m, value), x, y, z);
                }
              });
        } else {
          for (int m = -l; m <= l; ++m) sink(l, m, c, sum(l, m, value));
        }
      });
    }
  }

 private:
  // What Y_l^m is multiplied by: A_l, the step up from l-1, the step down from l+1, and A_l times the modulation's
  // gradient.
  enum Term { value, up, down, modulated };
  static constexpr int term_count = !has_gradients ? up : is_modulated ? modulated + 3 : modulated;
  static constexpr int degrees = has_gradients ? N + 1 : N;  // the step up from N-1 is of degree N
  static constexpr bool exists(int term, int l) {
    return term < term_count && (term == up ? l > 0 : term == down ? l + 1 < N : l < N);
  }
  using Sums = T[3][static_cast<std::size_t>(term_count)];

  Sums sums_[static_cast<std::size_t>(degrees * degrees)];
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
