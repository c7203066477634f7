// The registry's entries of the room `gather` (kernel_list.hpp).
//
// Some take part in a loop over lights for a sum over all orders m, "forward", or order by order, "reversed"
// [1, section 5.1]: in a loop over m around the loop over lights, few sums are alive at a time. With an order they take
// or give the coefficients of m and -m alone.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <type_traits>

#include "../gather/hvl.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

namespace detail {
template <class Io, class T>
void take(Io& io, const char* parameter, Domain domain, T (&vector)[3]) {
  const auto values = io.vector(parameter, domain);
  for (std::size_t i = 0; i < 3; ++i) vector[i] = values[i];
}
}  // namespace detail

struct TangentTowards : Kernel {
  static constexpr const char* name = "tangent_towards";
  static constexpr const char* summary =
      "The unit tangent, at a normal, of the frame where a direction has phi = 0: a receiver's, towards the eye.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    T normal[3], direction[3], tangent[3];
    detail::take(io, "normal", Domain::unit_vector, normal);
    detail::take(io, "direction", Domain::position, direction);  // of any length, and not along the normal
    zonal::detail::tangent_towards(normal, direction, tangent);
    io.output_triples("tangent", 0).set(0, tangent[0], tangent[1], tangent[2]);
  }
};

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

/// Words, one after the other.
struct JoinedName {
  char text[64] = {};
  constexpr JoinedName(std::initializer_list<std::string_view> words) {
    std::size_t size = 0;
    for (const std::string_view word : words) {
      for (const char c : word) text[size++] = c;
    }
  }
};

/// What a name says of the virtual lights' kernel: what is about the normal, what has one band, which horizon it has.
constexpr JoinedName hvl_name(std::string_view first, int emission_bands, Horizon method, Symmetry symmetry) {
  return {first, symmetry == Symmetry::zonal ? "_zonal" : "", emission_bands == 1 ? "_diffuse" : "",
          method == Horizon::exact  ? "_exact"
          : method == Horizon::none ? "_no_horizon"
                                    : ""};
}

/// Of a receiver whose material is even in phi, or the same all about the normal.
template <int NE, Horizon method = Horizon::smoothstep, Symmetry symmetry = Symmetry::mirror>
struct HvlRadiance : Kernel {
  static_assert(NE == 1 || NE == 3, "the names know two numbers of bands");
  static constexpr JoinedName joined_name = hvl_name("hvl_radiance", NE, method, symmetry);
  static constexpr const char* name = joined_name.text;
  static constexpr int emission_bands = NE;
  static constexpr Horizon horizon = method;
  static constexpr const char* summary =
      symmetry == Symmetry::zonal
          ? (NE == 1 ? "The same of a diffuse one, to a receiver whose material is the same about the normal."
                     : "The same to a receiver whose material is the same about the normal: N coefficients.")
      : NE == 1 ? "The outgoing radiance that a diffuse virtual light causes: one band of emission."
                : "The outgoing radiance that a virtual light causes: three bands of emission.";
  static constexpr int order_count(int bands) { return symmetry == Symmetry::zonal ? 0 : bands; }
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    using Record = HvlRecord<NE, T>;
    Record light;
    detail::take(io, "light_position", Domain::light_position, light.position);
    detail::take(io, "light_normal", Domain::unit_vector, light.normal);
    detail::take(io, "light_tangent", Domain::unit_vector, light.tangent);
    light.radius = io.number("light_radius", Domain::radius);
    const auto emission = io.template triples<Record::emission_size>("light_emission", Domain::coefficient);
    for (int i = 0; i < 3 * Record::emission_size; ++i) {
      light.emission[i % 3][i / 3] = emission[static_cast<std::size_t>(i)];
    }
    ReceiverFrame<T> receiver;
    detail::take(io, "position", Domain::position, receiver.position);
    detail::take(io, "normal", Domain::unit_vector, receiver.normal);
    if constexpr (symmetry == Symmetry::zonal) {  // nobody asks
      for (T& component : receiver.tangent) component = T(0);
    } else {
      detail::take(io, "tangent", Domain::unit_vector, receiver.tangent);
    }

    const auto coefficients = io.template triples<coefficient_count(symmetry, N)>("material", Domain::coefficient);
    using Colour = glm::vec<3, T>;
    std::conditional_t<symmetry == Symmetry::zonal, Zh<N, Colour>, EvenSh<N, Colour>> material;
    for (int l = 0; l < N; ++l) {
      for (int m = 0; m <= l && has_order(symmetry, m); ++m) {
        const int i = coefficient_index(symmetry, l, m);
        for (int c = 0; c < 3; ++c) {
          const T coefficient = coefficients[static_cast<std::size_t>(3 * i + c)];
          material.values[i][c] = io.keeps(m) ? coefficient : T(0);
        }
      }
    }
    T radiance[3];
    hvl_radiance<N, NE, method>(light, receiver, material, radiance);
    io.output_triples("radiance", 0).set(0, radiance[0], radiance[1], radiance[2]);
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
