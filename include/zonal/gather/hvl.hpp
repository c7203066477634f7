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
// Anisotropic materials have no such symmetry. Their coefficients, anisotropic_table.hpp, are those of the same frames,
// but of m < 0 as well: N^2 at a receiver, NE (NE+1)/2 at a light. A material that is the same all about the normal, as
// Lambert's is, has more of it: N coefficients. The kernel below is one, and takes what it is given: Zh, EvenSh or Sh,
// EvenEmission or AnyEmission.
//
// What a light sends out is read from the material's table at the direction to the primary light, as what a receiver
// reflects is at the direction to the eye: that takes f(a, b) = f(b, a). Of measured materials that are not reciprocal
// (rgl.hpp) the receiver's part is right, and the light's that of the exchanged directions; VPL, VSL and paths ask for
// f(light, eye) at both.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "../basis/evaluate.hpp"
#include "../basis/symmetry.hpp"
#include "../lobe/cap.hpp"
#include "../material/anisotropic_rows.hpp"
#include "../material/material_rows.hpp"
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

/// What a light sends, even in z and in phi: m >= 0 only,
struct EvenEmission {
  static constexpr Symmetry symmetry = Symmetry::mirror;
  static constexpr int index(int l, int m) { return emission_index(l, m); }
  static constexpr int size(int bands) { return emission_index(bands, bands % 2); }
};

/// and even in z alone, both signs of m.
struct AnyEmission {
  static constexpr Symmetry symmetry = Symmetry::none;
  static constexpr int index(int l, int m) { return l * (l + 1) / 2 + (l + m) / 2; }
  static constexpr int size(int bands) { return bands * (bands + 1) / 2; }
};

namespace detail {

/// What there is of the basis at (x, y, z), to sink(l, m, value): from z, from x and z, or from all; y is called for.
template <int N, Symmetry symmetry, class T, class Y, class Sink>
ZONAL_INLINE inline void evaluate_of(const T& x, const Y& y, const T& z, const Sink& sink) {
  if constexpr (symmetry == Symmetry::zonal) {
    evaluate_zonal<N>(z, [&](auto l, const T& value) ZONAL_INLINE { sink(l, Index<0>{}, value); });
  } else if constexpr (symmetry == Symmetry::mirror) {
    evaluate_even<N>(x, z, sink);
  } else {
    evaluate<N>(x, y(), z, sink);
  }
}

/// Coefficients are colours, or numbers where the material has one colour, which its caller multiplies by.
template <class Coefficients>
inline constexpr int channels_of = std::is_arithmetic_v<std::decay_t<decltype(Coefficients::values[0])>> ? 1 : 3;

template <class F>
ZONAL_INLINE inline const auto& channel_of(const F& f, [[maybe_unused]] int c) {
  if constexpr (std::is_arithmetic_v<F>) {
    return f;
  } else {
    return f[c];
  }
}

/// The y of a direction in the frame of a normal and a tangent.
template <class T>
ZONAL_INLINE inline T across(const T (&direction)[3], const T (&normal)[3], const T (&tangent)[3]) {
  T bitangent[3];
  cross3(normal, tangent, bitangent);
  return dot3(direction, bitangent);
}

/// Coefficients as a kernel without symmetry takes them: those of a function that is even in phi with their zeros, and
/// zonal ones as they are.
template <int N, class T>
constexpr Sh<N, T> all_orders(const EvenSh<N, T>& even) {
  Sh<N, T> sh{};
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) sh(l, m) = even(l, m);
  }
  return sh;
}
template <int N, class T>
constexpr Zh<N, T> all_orders(const Zh<N, T>& zonal) {
  return zonal;
}

}  // namespace detail

/// What a sphere light needs to be seen: a light of the cache as the kernel reads it, one lane or a packet of them.
template <int NE, class T, class Emission = EvenEmission>
struct HvlRecord {
  static constexpr int emission_size = Emission::size(NE);
  T position[3], normal[3];
  T tangent[3];  // the direction to the primary light, projected on the tangent plane
  T radius;
  T emission[3][static_cast<std::size_t>(emission_size)];  // RGB: Phi F' / r^2, pi times the radiance

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(normal), visit(tangent), visit(radius), visit(emission);
  }
};

/// Numbers of a record, by its bands of emission.
template <class Emission = EvenEmission>
constexpr int hvl_record_size(int emission_bands) {
  return 10 + 3 * Emission::size(emission_bands);
}
static_assert(hvl_record_size(1) == field_count<HvlRecord<1, float>> &&
              hvl_record_size(3) == field_count<HvlRecord<3, float>>);

/// The same light with the coefficients of m < 0, which are zero.
template <int NE, class T>
ZONAL_INLINE inline HvlRecord<NE, T, AnyEmission> without_symmetry(const HvlRecord<NE, T, EvenEmission>& light) {
  HvlRecord<NE, T, AnyEmission> result;
  for (int i = 0; i < 3; ++i) {
    result.position[i] = light.position[i];
    result.normal[i] = light.normal[i];
    result.tangent[i] = light.tangent[i];
    for (int l = 0; l < NE; ++l) {
      for (int m = -l; m <= l; m += 2) {
        result.emission[i][AnyEmission::index(l, m)] = m < 0 ? T(0) : light.emission[i][EvenEmission::index(l, m)];
      }
    }
  }
  result.radius = light.radius;
  return result;
}

/// A light that sends `factor` times as much.
template <int NE, class T, class Emission>
ZONAL_INLINE inline HvlRecord<NE, T, Emission> scaled(HvlRecord<NE, T, Emission> light, const T& factor) {
  for (auto& channel : light.emission) {
    for (T& coefficient : channel) coefficient = coefficient * factor;
  }
  return light;
}

namespace detail {

/// What a receiver's material makes of a cap of light: sum_l A_l / pi sum_m F_l^m Y_l^m, to reflected[channels].
template <int N, class Material, class T>
ZONAL_INLINE inline void reflect(const Material& material, const ReceiverFrame<T>& receiver, const T (&direction)[3],
                                 const T& cosine, const SphericalCap<T>& cap,
                                 T (&reflected)[std::size_t{channels_of<Material>}]) {
  constexpr Symmetry symmetry = symmetry_of<Material>;
  constexpr int channels = channels_of<Material>;
  const auto for_each_value = [&](const auto& sink) ZONAL_INLINE {
    evaluate_of<N, symmetry>(
        dot3(direction, receiver.tangent),
        [&]() ZONAL_INLINE { return across(direction, receiver.normal, receiver.tangent); }, cosine, sink);
  };
  const auto f = [&](int l, int m, int c)
                     ZONAL_INLINE { return T(channel_of(material.values[coefficient_index(symmetry, l, m)], c)); };
  for (T& sum : reflected) sum = T(0);
  if constexpr (symmetry == Symmetry::zonal) {
    T value[static_cast<std::size_t>(N)];
    for_each_value([&](auto l, auto, const T& y) ZONAL_INLINE { value[l] = y; });
    hemisphere_cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE {
      const T weight = sum * value[l];
      for (int c = 0; c < channels; ++c) reflected[c] = reflected[c] + weight * f(l, 0, c);
    });
  } else {  // one sum per degree and channel, then the cap's coefficient
    T by_degree[static_cast<std::size_t>(channels)][static_cast<std::size_t>(N)] = {};
    for (auto& channel : by_degree) {
      for (T& sum : channel) sum = T(0);
    }
    for_each_value([&](auto l, auto m, const T& y) ZONAL_INLINE {
      for (int c = 0; c < channels; ++c) by_degree[c][l] = by_degree[c][l] + f(l, m, c) * y;
    });
    hemisphere_cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE {
      for (int c = 0; c < channels; ++c) reflected[c] = reflected[c] + sum * by_degree[c][l];
    });
  }
}

}  // namespace detail

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `material` is F at the
/// outgoing direction, RGB by degree and order: EvenSh, or Sh of an anisotropic material, or Zh, by degree, of one that
/// is the same all about the normal; or numbers instead of colours, of a material of one colour that the caller
/// multiplies by. A receiver inside the sphere sees a hemisphere; one at its very centre sees nothing, for there is no
/// direction to it.
template <int N, int NE, Horizon method, class T, class Emission, class Material>
ZONAL_INLINE inline void hvl_radiance(const HvlRecord<NE, T, Emission>& light, const ReceiverFrame<T>& receiver,
                                      const Material& material, T (&radiance)[3]) {
  static_assert(Material::bands == N, "the material's coefficients are those of N bands");
  // Where the light stands, and how large it looks.
  const LightDirection<T> to_light = look_at(light, receiver);
  const auto& direction = to_light.direction;
  const T cos_receiver = detail::dot3(direction, receiver.normal);
  const T cos_light = maximum(T(0), -detail::dot3(direction, light.normal));
  const auto cap = SphericalCap<T>::from_sphere(to_light.distance, to_light.inverse, light.radius);

  // What it sends towards the receiver; a band-limited emission that rings below zero sends nothing.
  T sent[3] = {T(0), T(0), T(0)};
  detail::evaluate_of<NE, Emission::symmetry>(
      -detail::dot3(direction, light.tangent),
      [&]() ZONAL_INLINE { return -detail::across(direction, light.normal, light.tangent); },
      -detail::dot3(direction, light.normal),
      [&](auto l, auto m, const T& y) ZONAL_INLINE {
        if constexpr (is_even_in_z(l, m)) {
          for (int c = 0; c < 3; ++c) sent[c] = sent[c] + light.emission[c][Emission::index(l, m)] * y;
        }
      });
  const T geometry = cos_light * horizon<method>(cap, cos_receiver);

  T reflected[std::size_t{detail::channels_of<Material>}];
  detail::reflect<N>(material, receiver, direction, cos_receiver, cap, reflected);
  for (int c = 0; c < 3; ++c) {
    radiance[c] = maximum(sent[c], T(0)) * geometry * reflected[detail::channels_of<Material> == 3 ? c : 0];
  }
}

/// The virtual lights in packets. Lights without power or material are left out: they contribute exactly nothing. One
/// without area is a point light, for its radius counts as least_light_radius. NE bands of emission; 1 is exact for
/// diffuse emitters and needs no evaluation at all. Lights of anisotropic materials stand in packets of their own.
template <int NE>
class HvlCache {
 public:
  using Lanes = Packet<float, kNativeLanes>;
  template <class T>
  using Record = HvlRecord<NE, T>;
  template <class T>
  using AnisotropicRecord = HvlRecord<NE, T, AnyEmission>;

  HvlCache() = default;
  explicit HvlCache(const std::vector<VirtualLight>& lights) {
    for (const VirtualLight& light : lights) {
      if (!shines(light)) continue;
      if (light.anisotropic != nullptr) {
        append(anisotropic_record(light));
      } else {
        append(isotropic_record(light));
      }
    }
  }

  /// Without lights; keeps its memory.
  void clear() {
    records_.clear();
    anisotropic_.clear();
  }
  void append(const HvlRecord<NE, float>& light) { records_.append(light); }
  void append(const HvlRecord<NE, float, AnyEmission>& light) { anisotropic_.append(light); }

  /// Another light in place of one; `index` counts the lights that shine, those of isotropic materials first. One that
  /// does not shine leaves the old one's place black. False, and nothing is changed, where there is no light of this
  /// number, or one material is anisotropic and the other is not.
  [[nodiscard]] bool replace(int index, const VirtualLight& light) {
    if (index < 0 || size() <= index) return false;
    const bool is_isotropic = index < records_.size(), is_lit = shines(light);
    if (is_lit && is_isotropic != (light.anisotropic == nullptr)) return false;
    if (is_isotropic) {
      records_.replace(index, is_lit ? isotropic_record(light) : scaled(records_.record(index), 0.0F));
    } else {
      const int i = index - records_.size();
      anisotropic_.replace(i, is_lit ? anisotropic_record(light) : scaled(anisotropic_.record(i), 0.0F));
    }
    return true;
  }

  /// The lights that shine.
  int size() const { return records_.size() + anisotropic_.size(); }
  /// Those of isotropic materials, in packets.
  int packet_count() const { return records_.packet_count(); }
  ZONAL_INLINE Record<Lanes> packet(int index) const { return records_.packet(index); }
  /// Both as they are kept.
  const PacketArray<Record>& isotropic() const { return records_; }
  const PacketArray<AnisotropicRecord>& anisotropic() const { return anisotropic_; }

  /// Lights as a kernel without symmetry takes them: those of isotropic materials, then those of anisotropic ones.
  class WithoutSymmetry {
   public:
    using Lanes = HvlCache::Lanes;
    WithoutSymmetry(const HvlCache& cache, int first) : cache_(cache), first_(first) {}

    int packet_count() const { return cache_.records_.packet_count() + cache_.anisotropic_.packet_count() - first_; }
    ZONAL_INLINE AnisotropicRecord<Lanes> packet(int index) const {
      const int isotropic = cache_.records_.packet_count(), i = first_ + index;
      return i < isotropic ? zonal::without_symmetry(cache_.records_.packet(i))
                           : cache_.anisotropic_.packet(i - isotropic);
    }

   private:
    const HvlCache& cache_;
    int first_;
  };
  WithoutSymmetry all_lights() const { return {*this, 0}; }
  WithoutSymmetry anisotropic_lights() const { return {*this, records_.packet_count()}; }

 private:
  static bool shines(const VirtualLight& light) {
    return light.flux != glm::vec3(0) && glm::dot(light.normal, light.to_primary) > 0 &&
           (light.material != nullptr || light.anisotropic != nullptr);
  }

  static HvlRecord<NE, float> isotropic_record(const VirtualLight& light) {
    const glm::vec3 tangent = detail::tangent_towards(light.normal, light.to_primary);
    const float cos_primary = glm::dot(light.normal, light.to_primary);
    return record<EvenEmission>(light, tangent, light.material->template without_cosine<NE>(cos_primary));
  }
  static HvlRecord<NE, float, AnyEmission> anisotropic_record(const VirtualLight& light) {
    const detail::AnisotropicView primary(light.to_primary, light.normal, light.tangent);
    return record<AnyEmission>(light, primary.tangent,
                               light.anisotropic->template without_cosine<NE>(primary.direction));
  }

  template <class Emission, class Coefficients>
  static HvlRecord<NE, float, Emission> record(const VirtualLight& light, const glm::vec3& tangent,
                                               const Coefficients& reflected) {
    const float radius = (std::max)(light.radius, least_light_radius);
    const glm::vec3 scale = light.flux / (radius * radius);
    HvlRecord<NE, float, Emission> record;
    for (int i = 0; i < 3; ++i) {
      record.position[i] = light.position[i];
      record.normal[i] = light.normal[i];
      record.tangent[i] = tangent[i];
    }
    for (int l = 0; l < NE; ++l) {
      for (int m = has_order(Emission::symmetry, -1) ? -l : l % 2; m <= l; m += 2) {
        const glm::vec3 sent = scale * reflected(l, m);
        for (int c = 0; c < 3; ++c) record.emission[c][Emission::index(l, m)] = sent[c];
      }
    }
    record.radius = radius;
    return record;
  }

  PacketArray<Record> records_;
  PacketArray<AnisotropicRecord> anisotropic_;
};

namespace detail {

/// Whether a target multiplies by a number in memory in all lanes. If not, a kernel of many packets had better find
/// such registers in memory: with AVX2 that saves a sixth of a gather's time.
template <class Lanes>
inline constexpr bool has_number_operands = Lanes::width >= 16;
template <class Lanes, template <int, class> class Kind, int N>
std::conditional_t<has_number_operands<Lanes>, const Kind<N, glm::vec3>&, Kind<N, glm::vec<3, Lanes>>> in_lanes(
    const Kind<N, glm::vec3>& coefficients) {
  if constexpr (has_number_operands<Lanes>) {
    return coefficients;
  } else {
    return Kind<N, glm::vec<3, Lanes>>(coefficients);
  }
}
template <class Lanes, int N>
const Zh<N, float>& in_lanes(const Zh<N, float>& coefficients) {
  return coefficients;
}

/// The sum over some lights of a receiver whose coefficients F, in the frame given, are known. Only few kinds of lights
/// and coefficients meet, EvenSh with those of isotropic materials and Sh with WithoutSymmetry: where one side has no
/// symmetry, the other is taken without it too, for a kernel takes long to compile. That of Zh does not.
template <int N, int NE, Horizon method, class Lights, class Material>
glm::vec3 gather_from(const Lights& lights, const ReceiverFrame<typename Lights::Lanes>& frame,
                      const Material& coefficients, const Visibility& visible) {
  const auto& material = in_lanes<typename Lights::Lanes>(coefficients);
  return sum_packets(lights, visible, [&](const auto& light, auto& rgb) ZONAL_INLINE {
    hvl_radiance<N, NE, method>(light, frame, material, rgb);
  });
}

/// The sum over all lights, whichever the receiver's coefficients.
template <int N, int NE, Horizon method, class Material>
glm::vec3 gather_from_all(const HvlCache<NE>& cache, const Receiver& receiver, const Material& coefficients,
                          const Visibility& visible) {
  const auto frame = frame_of<typename HvlCache<NE>::Lanes>(receiver);
  glm::vec3 sum = gather_from<N, NE, method>(cache, frame, coefficients, visible);
  if (const auto others = cache.anisotropic_lights(); others.packet_count() > 0) {
    sum += gather_from<N, NE, method>(others, frame, all_orders(coefficients), visible);
  }
  return (glm::max)(sum, glm::vec3(0));
}

}  // namespace detail

/// Outgoing radiance, RGB, at the receiver from all lights of the cache: one bounce. `coefficients` are the receiver's
/// material, F of MaterialTable at the direction to the eye; being linear in the material, they may be mixed from
/// several tables, as where a texture colours a part of it. Negative sums, which ringing can leave, are cut to zero.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const EvenSh<N, glm::vec3>& coefficients,
                 const Visibility& visible = {}) {
  return detail::gather_from_all<N, NE, method>(cache, receiver, coefficients, visible);
}

/// The same of a material that is the same all about the normal: F_l^0 alone, about_axis(F).
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const Zh<N, glm::vec3>& coefficients,
                 const Visibility& visible = {}) {
  return detail::gather_from_all<N, NE, method>(cache, receiver, coefficients, visible);
}
/// The same of such a material in one colour, by which the result is to be multiplied.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const Zh<N, float>& coefficients,
                 const Visibility& visible = {}) {
  return detail::gather_from_all<N, NE, method>(cache, receiver, coefficients, visible);
}

/// The same with N bands of the table, of which those that it does not have are zero.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const MaterialTable& material,
                 const Visibility& visible = {}) {
  const auto coefficients = material.with_cosine<N>(glm::dot(receiver.normal, receiver.outgoing));
  return gather<N, NE, method>(cache, receiver, coefficients, visible);
}

/// The same of an anisotropic material, in the frame of the receiver's tangent.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const HvlCache<NE>& cache, const Receiver& receiver, const AnisotropicTable& material,
                 const Visibility& visible = {}) {
  using Lanes = typename HvlCache<NE>::Lanes;
  const detail::AnisotropicView eye(receiver.outgoing, receiver.normal, receiver.tangent);
  const auto frame = detail::frame_of<Lanes>(receiver, eye.tangent);
  const Sh<N, glm::vec3> coefficients = material.with_cosine<N>(eye.direction);
  return (glm::max)(detail::gather_from<N, NE, method>(cache.all_lights(), frame, coefficients, visible), glm::vec3(0));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
