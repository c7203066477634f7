// The registry's entries of the room `gather` (kernel_list.hpp).
//
// Some take part in a loop over lights for a sum over all orders m, "forward", or order by order, "reversed"
// [1, section 5.1]: in a loop over m around the loop over lights, few sums are alive at a time. With an order they take
// or give the coefficients of m and -m alone.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <cstddef>

#include "../gather/hvl.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

template <Horizon method>
struct HorizonOf : Kernel {
  static constexpr const char* name = method == Horizon::exact ? "horizon_exact" : "horizon_smoothstep";
  static constexpr const char* summary = "How much of a cap, up to the hemisphere, stands above the horizon: 0 to 1.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto cap = io.cap("cap", Domain::half_angle);
    const auto cos_angle = io.number("cos_angle", Domain::cosine);
    io.output("share", 0)[0] = horizon<method>(cap, cos_angle);
  }
};

template <int NE, Horizon method = Horizon::smoothstep>
struct HvlRadiance : Kernel {
  static constexpr const char* name = method == Horizon::exact  ? "hvl_radiance_exact"
                                      : method == Horizon::none ? "hvl_radiance_no_horizon"
                                      : NE == 1                 ? "hvl_radiance_diffuse"
                                                                : "hvl_radiance";
  static constexpr int emission_bands = NE;
  static constexpr Horizon horizon = method;
  static constexpr const char* summary =
      NE == 1 ? "The outgoing radiance that a diffuse virtual light causes: one band of emission."
              : "The outgoing radiance that a virtual light causes: three bands of emission.";
  static constexpr int order_count(int bands) { return bands; }
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    using Record = HvlRecord<NE, T>;
    Record light;
    take(io, "light_position", Domain::light_position, light.position);
    take(io, "light_normal", Domain::unit_vector, light.normal);
    take(io, "light_tangent", Domain::unit_vector, light.tangent);
    light.radius = io.number("light_radius", Domain::radius);
    const auto emission = io.template triples<Record::emission_size>("light_emission", Domain::coefficient);
    for (int i = 0; i < 3 * Record::emission_size; ++i) {
      light.emission[i % 3][i / 3] = emission[static_cast<std::size_t>(i)];
    }
    ReceiverFrame<T> receiver;
    take(io, "position", Domain::position, receiver.position);
    take(io, "normal", Domain::unit_vector, receiver.normal);
    take(io, "tangent", Domain::unit_vector, receiver.tangent);

    constexpr int material_size = even_index(N, 0);
    const auto coefficients = io.template triples<material_size>("material", Domain::coefficient);
    EvenSh<N, glm::vec<3, T>> material;
    for (int l = 0; l < N; ++l) {
      for (int m = 0; m <= l; ++m) {
        for (int c = 0; c < 3; ++c) {
          const T coefficient = coefficients[static_cast<std::size_t>(3 * even_index(l, m) + c)];
          material(l, m)[c] = io.keeps(m) ? coefficient : T(0);
        }
      }
    }
    T radiance[3];
    hvl_radiance<N, NE, method>(light, receiver, material, radiance);
    io.output_triples("radiance", 0).set(0, radiance[0], radiance[1], radiance[2]);
  }

 private:
  template <class Io, class T>
  static void take(Io& io, const char* parameter, Domain domain, T (&vector)[3]) {
    const auto values = io.vector(parameter, domain);
    for (std::size_t i = 0; i < 3; ++i) vector[i] = values[i];
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
