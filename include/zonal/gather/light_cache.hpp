// Virtual lights whose emission is their surface's BRDF itself: what VPL, VSL and zonal HVL gather.
//
// A light reflects Phi_j f_y(w_l, w) W/sr, times the cosine at y, into the direction w. The diffuse part of it is one
// colour per light; what is left of its material, the glossy lobes, is shared by all lights of the same material, which
// stand together in packets, so that a packet evaluates one BRDF.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "../material/brdf.hpp"
#include "packet_array.hpp"
#include "receiver.hpp"
#include "virtual_light.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A light as the kernels read it, one lane or a packet of them.
template <class T>
struct LightRecord {
  T position[3], normal[3];
  T tangent[3];  // the direction to the primary light, projected on the tangent plane; or an anisotropic surface's own
  T primary[3];  // the direction to the primary light, in that frame
  T radius;
  T flux[3];     // W, RGB
  T diffuse[3];  // W/sr, RGB: flux times the BRDF of the diffuse lobes
  T turn[2];     // cosine and sine of an angle of its own, and
  T shift;       // a number of its own in [0, 1): so that samples of different lights differ

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(normal), visit(tangent), visit(primary), visit(radius);
    visit(flux), visit(diffuse), visit(turn), visit(shift);
  }
};

/// The virtual lights by glossy material. Lights without power or material are left out.
class LightCache {
 public:
  /// Lights that share their glossy lobes; none for diffuse lights.
  struct Group {
    Brdf glossy;
    PacketArray<LightRecord> lights;
  };

  LightCache() = default;
  explicit LightCache(const std::vector<VirtualLight>& lights) {
    std::vector<std::pair<const Brdf*, std::size_t>> known;  // materials met, and the group of each
    for (const VirtualLight& light : lights) {
      const bool shines =
          light.flux != glm::vec3(0) && light.brdf != nullptr && glm::dot(light.normal, light.to_primary) > 0;
      if (shines) groups_[group_of(light.brdf, known)].lights.append(record(light));
    }
  }

  const std::vector<Group>& groups() const { return groups_; }

  /// The lights that shine.
  int size() const {
    int sum = 0;
    for (const Group& group : groups_) sum += group.lights.size();
    return sum;
  }

 private:
  std::size_t group_of(const Brdf* brdf, std::vector<std::pair<const Brdf*, std::size_t>>& known) {
    for (const auto& [material, group] : known) {
      if (material == brdf) return group;
    }
    Brdf glossy = glossy_part(*brdf);
    std::size_t group = groups_.size();
    if (glossy.lobes.empty()) {  // diffuse lights are all alike
      for (std::size_t i = 0; i < groups_.size(); ++i) group = groups_[i].glossy.lobes.empty() ? i : group;
    }
    if (group == groups_.size()) groups_.push_back({std::move(glossy), {}});
    known.emplace_back(brdf, group);
    return group;
  }

  LightRecord<float> record(const VirtualLight& light) const {
    const glm::vec3 tangent =
        detail::tangent_towards(light.normal, is_isotropic(*light.brdf) ? light.to_primary : light.tangent);
    const glm::vec3 primary = detail::in_frame(light.to_primary, light.normal, tangent);
    const glm::vec3 diffuse = light.flux * diffuse_albedo(*light.brdf) / float(kPi);
    LightRecord<float> record;
    for (int i = 0; i < 3; ++i) {
      record.position[i] = light.position[i];
      record.normal[i] = light.normal[i];
      record.tangent[i] = tangent[i];
      record.primary[i] = primary[i];
      record.flux[i] = light.flux[i];
      record.diffuse[i] = diffuse[i];
    }
    record.radius = (std::max)(light.radius, least_light_radius);
    // Two well spread sequences; [0, 1) up to a million lights.
    const double golden = 0.6180339887498949 * size(), plastic = 0.7548776662466927 * size();
    const double angle = 2.0 * double(kPi) * (golden - std::floor(golden));
    record.turn[0] = float(std::cos(angle));
    record.turn[1] = float(std::sin(angle));
    record.shift = (std::min)(float(plastic - std::floor(plastic)), 0x1.fffffep-1F);
    return record;
  }

  std::vector<Group> groups_;
};

namespace detail {

/// A direction in the frame of a normal and a tangent.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> to_local(const T (&direction)[3], const T (&normal)[3], const T (&tangent)[3]) {
  T bitangent[3];
  cross3(normal, tangent, bitangent);
  return {dot3(direction, tangent), dot3(direction, bitangent), dot3(direction, normal)};
}

/// What a light reflects against the unit direction `towards_light`, W/sr without the cosine at the light. `glossy` is
/// that of the light's group.
template <class T>
ZONAL_INLINE inline void reflected_flux(const LightRecord<T>& light, const Brdf& glossy, const T (&towards_light)[3],
                                        T (&sent)[3]) {
  for (int c = 0; c < 3; ++c) sent[c] = light.diffuse[c];
  if (glossy.lobes.empty()) return;
  const glm::vec<3, T> from_primary(light.primary[0], light.primary[1], light.primary[2]);
  const glm::vec<3, T> away = to_local(towards_light, light.normal, light.tangent) * T(-1);
  const glm::vec<3, T> f = evaluate(glossy, from_primary, away);
  for (int c = 0; c < 3; ++c) sent[c] = sent[c] + light.flux[c] * f[c];
}

/// The tangent of the frame in which to ask a receiver's BRDF: the eye has phi = 0 there, unless the material is
/// anisotropic and has a frame of its own.
inline glm::vec3 brdf_tangent(const Receiver& receiver, const Brdf& brdf) {
  return tangent_towards(receiver.normal, is_isotropic(brdf) ? receiver.outgoing : receiver.tangent);
}

/// The direction to the eye in the receiver's frame, where it has phi = 0.
inline glm::vec3 local_outgoing(const Receiver& receiver) {
  const glm::vec3 tangent = tangent_towards(receiver.normal, receiver.outgoing);
  return {glm::dot(receiver.outgoing, tangent), 0.0F, glm::dot(receiver.outgoing, receiver.normal)};
}

/// The sum of radiance(group, record, rgb) over all packets of all groups.
template <class Radiance>
ZONAL_INLINE inline glm::vec3 sum_groups(const LightCache& cache, const Visibility& visible, const Radiance& radiance) {
  glm::vec3 sum(0.0F);
  for (const LightCache::Group& group : cache.groups()) {
    sum += sum_packets(group.lights, visible,
                       [&](const auto& record, auto& rgb) ZONAL_INLINE { radiance(group, record, rgb); });
  }
  return sum;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
