// Virtual point lights [1]: all of a light's power comes from its centre.
//
//   L_o(x) = sum_j f_x(w, wo) cos_x Phi_j f_y(w_l, -w) cos_y / d^2
//
// Without bias as the number of lights grows, if what stands between is accounted for. But 1/d^2 has no bound, which is
// seen as a bright spot about each light; nor has a glossy f_x, which mirrors each light as a spot of its own.
//
// [1] A. Keller, Instant radiosity, SIGGRAPH 1997.
#pragma once

#include "light_cache.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `outgoing` is the
/// direction to the eye in the receiver's frame.
template <class T>
ZONAL_INLINE inline void vpl_radiance(const LightRecord<T>& light, const Brdf& glossy, const ReceiverFrame<T>& receiver,
                                      const glm::vec<3, T>& outgoing, const Brdf& brdf, const T& clamp,
                                      T (&radiance)[3]) {
  const LightDirection<T> to_light = look_at(light, receiver);
  const glm::vec<3, T> incoming = detail::to_local(to_light.direction, receiver.normal, receiver.tangent);
  const T cos_light = maximum(T(0), -detail::dot3(to_light.direction, light.normal));
  const T distance = maximum(maximum(to_light.distance, clamp * light.radius), T(least_light_radius));
  const T geometry = maximum(T(0), incoming.z) * cos_light / (distance * distance);
  T sent[3];
  detail::reflected_flux(light, glossy, to_light.direction, sent);
  const glm::vec<3, T> f = evaluate(brdf, incoming, outgoing);
  for (int c = 0; c < 3; ++c) radiance[c] = f[c] * sent[c] * geometry;
}

/// Outgoing radiance, RGB, at a receiver of material `brdf` from all lights of the cache: one bounce. `clamp` is in
/// radii: a light nearer than that many of its own radii counts as standing there, which takes away the bright spots,
/// and with them light; 0 leaves all as it is, down to the distance least_light_radius.
inline glm::vec3 gather_vpl(const LightCache& cache, const Receiver& receiver, const Brdf& brdf, float clamp = 0.0F,
                            const Visibility& visible = {}) {
  using Lanes = PacketArray<LightRecord>::Lanes;
  const glm::vec3 tangent = detail::brdf_tangent(receiver, brdf);
  const auto frame = detail::frame_of<Lanes>(receiver, tangent);
  const glm::vec<3, Lanes> outgoing(detail::in_frame(receiver.outgoing, receiver.normal, tangent));
  return detail::sum_groups(cache, visible, [&](const LightCache::Group& group, const auto& light, auto& rgb) {
    vpl_radiance(light, group.glossy, frame, outgoing, brdf, Lanes(clamp), rgb);
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
