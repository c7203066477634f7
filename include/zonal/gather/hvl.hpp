// Harmonics virtual lights: the indirect light that reaches a point from a cache of virtual lights.
//
// A light j at y is a sphere that sends L_j = Phi_j f_y(w_l, -w) max(0, n_j . -w) / (pi r^2) towards x, w the direction
// from x to y. At x it is a cap of sin a = r/d, whose projection in x's frame meets the material's, F = f cos:
//
//   L_o(x) = sum_j L_j H(n_x, w) sum_l A_l(a) sum_m F_l^m Y_l^m(w),   A_l = sqrt(4pi/(2l+1)) z_l     [1] Eq. 19-22
//
// Both frames are chosen so that their fixed direction (the eye at x, the primary light at y) has phi = 0: isotropic
// materials are then even in phi, and N(N+1)/2 coefficients do what N^2 would. What a light sends out is even in z as
// well (projection.hpp): of its coefficients only those of even l+m are there.
//
// What a light sends out is read from the material's table at the direction to the primary light, as what a receiver
// reflects is at the direction to the eye: that takes f(a, b) = f(b, a). Of measured materials that are not reciprocal
// (rgl.hpp) the receiver's part is right, and the light's that of the exchanged directions; VPL, VSL and paths ask for
// f(light, eye) at both.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
#pragma once

#include <algorithm>
#include <vector>

#include "../basis/evaluate.hpp"
#include "../lobe/cap.hpp"
#include "../scalar/packet.hpp"
#include "../scalar/vector3.hpp"
#include "../transform/orient.hpp"
#include "horizon.hpp"
#include "packet_array.hpp"
#include "receiver.hpp"
#include "virtual_light.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Where the emission of degree l and order m stands, 0 <= m <= l, l+m even; emission_index(NE, 0) or (NE, 1),
/// whichever is even, is how many there are in NE bands.
constexpr int emission_index(int l, int m) { return (l + 1) * (l + 1) / 4 + m / 2; }

/// What a sphere light needs to be seen: a light of the cache as the kernel reads it, one lane or a packet of them.
template <int NE, class T>
struct HvlRecord {
  static constexpr int emission_size = emission_index(NE, NE % 2);
  T position[3], normal[3];
  T tangent[3];  // the direction to the primary light, projected on the tangent plane
  T radius;
  T emission[3][static_cast<std::size_t>(emission_size)];  // RGB: Phi F' / r^2, pi times the radiance

  /// field(i) for i < field_count: the order in which the cache stores them.
  static constexpr int field_count = 10 + 3 * emission_size;
  ZONAL_INLINE T& field(int i) {
    if (i < 9) return (i < 3 ? position : i < 6 ? normal : tangent)[i % 3];
    if (i == 9) return radius;
    return emission[(i - 10) / emission_size][(i - 10) % emission_size];
  }
};

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `material` is F at the
/// outgoing direction, RGB by degree and order. A receiver inside the sphere sees a hemisphere; one at its very
/// centre sees nothing, for there is no direction to it.
template <int N, int NE, Horizon method, class T, class Lane>
ZONAL_INLINE inline void hvl_radiance(const HvlRecord<NE, T>& light, const ReceiverFrame<T>& receiver,
                                      const EvenSh<N, glm::vec<3, Lane>>& material, T (&radiance)[3]) {
  // Where the light stands, and how large it looks.
  const auto [direction, distance] = look_at(light, receiver);
  const T cos_receiver = detail::dot3(direction, receiver.normal);
  const T cos_light = maximum(T(0), -detail::dot3(direction, light.normal));
  const auto cap = SphericalCap<T>::from_sphere(distance, light.radius);

  // What it sends towards the receiver; a band-limited emission that rings below zero sends nothing.
  T sent[3] = {T(0), T(0), T(0)};
  evaluate_even<NE>(-detail::dot3(direction, light.tangent), -detail::dot3(direction, light.normal),
                    [&](auto l, auto m, const T& y) ZONAL_INLINE {
                      if constexpr (is_even_in_z(l, m)) {
                        for (int c = 0; c < 3; ++c) sent[c] = sent[c] + light.emission[c][emission_index(l, m)] * y;
                      }
                    });
  const T geometry = cos_light * horizon<method>(cap, cos_receiver);

  // What the receiver's material makes of it: one sum per degree and channel, then the cap's coefficient.
  T by_degree[3][static_cast<std::size_t>(N)] = {};
  for (auto& channel : by_degree) {
    for (T& sum : channel) sum = T(0);
  }
  evaluate_even<N>(detail::dot3(direction, receiver.tangent), cos_receiver,
                   [&](auto l, auto m, const T& y) ZONAL_INLINE {
                     const auto& f = material.values[even_index(l, m)];
                     for (int c = 0; c < 3; ++c) by_degree[c][l] = by_degree[c][l] + T(f[c]) * y;
                   });
  T reflected[3] = {T(0), T(0), T(0)};
  detail::hemisphere_cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE {  // A_l / pi
    for (int c = 0; c < 3; ++c) reflected[c] = reflected[c] + sum * by_degree[c][l];
  });
  for (int c = 0; c < 3; ++c) radiance[c] = maximum(sent[c], T(0)) * geometry * reflected[c];
}

/// The virtual lights in packets. Lights without power or material are left out: they contribute exactly nothing. One
/// without area is a point light, for its radius counts as least_light_radius. NE bands of emission; 1 is exact for
/// diffuse emitters and needs no evaluation at all.
template <int NE>
class HvlCache {
 public:
  using Lanes = Packet<float, kNativeLanes>;
  template <class T>
  using Record = HvlRecord<NE, T>;

  HvlCache() = default;
  explicit HvlCache(const std::vector<VirtualLight>& lights) {
    for (const VirtualLight& light : lights) {
      const bool shines =
          light.flux != glm::vec3(0) && light.material != nullptr && glm::dot(light.normal, light.to_primary) > 0;
      if (shines) append(light);
    }
  }

  /// The lights that shine.
  int size() const { return records_.size(); }
  int packet_count() const { return records_.packet_count(); }
  ZONAL_INLINE Record<Lanes> packet(int index) const { return records_.packet(index); }

 private:
  void append(const VirtualLight& light) {
    const glm::vec3 tangent = detail::tangent_towards(light.normal, light.to_primary);
    const EvenSh<NE, glm::vec3> reflected =
        light.material->template without_cosine<NE>(glm::dot(light.normal, light.to_primary));
    const float radius = (std::max)(light.radius, least_light_radius);
    const glm::vec3 scale = light.flux / (radius * radius);

    Record<float> record;
    for (int i = 0; i < 3; ++i) {
      record.position[i] = light.position[i];
      record.normal[i] = light.normal[i];
      record.tangent[i] = tangent[i];
    }
    for (int l = 0; l < NE; ++l) {
      for (int m = l % 2; m <= l; m += 2) {
        const glm::vec3 sent = scale * reflected(l, m);
        for (int c = 0; c < 3; ++c) record.emission[c][emission_index(l, m)] = sent[c];
      }
    }
    record.radius = radius;
    records_.append(record);
  }

  PacketArray<Record> records_;
};

/// Outgoing radiance, RGB, at the receiver from all lights of the cache: one bounce, N bands of the receiver's
/// material, of which those beyond its table's are zero. Negative sums, which ringing can leave, are cut to zero.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const MaterialTable& material,
                 const Visibility& visible = {}) {
  using Lanes = typename HvlCache<NE>::Lanes;
  const auto frame = detail::frame_of<Lanes>(receiver);
  const EvenSh<N, glm::vec3> coefficients = material.with_cosine<N>(glm::dot(receiver.normal, receiver.outgoing));
  const auto radiance = [&](const HvlRecord<NE, Lanes>& light, Lanes(&rgb)[3])
                            ZONAL_INLINE { hvl_radiance<N, NE, method>(light, frame, coefficients, rgb); };
  return (glm::max)(detail::sum_packets(cache, visible, radiance), glm::vec3(0));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
