// Lights that were drawn for a group of receivers, by how they stand to it, and their gather.
#pragma once

#include "../gather/hvl.hpp"
#include "receiver_groups.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Those that are dark to the receivers are left out, and those that are clear of their horizon stand apart, for a
/// kernel that takes half the time; packets of one kind do not diverge.
template <int NE>
struct DrawnLights {
  HvlCache<NE> clear, across;

  /// Keeps its memory.
  void reset() {
    clear.clear();
    across.clear();
  }
  int size() const { return clear.size() + across.size(); }

  template <class Emission>
  void append(const HvlRecord<NE, float, Emission>& light, const ReceiverBox& receivers, bool cuts_at_horizon) {
    const auto vector = [](const float(&v)[3]) { return glm::vec3(v[0], v[1], v[2]); };
    switch (standing_of(receivers, vector(light.position), vector(light.normal), light.radius, cuts_at_horizon)) {
      case Standing::dark: break;
      case Standing::clear: clear.append(light); break;
      case Standing::across: across.append(light); break;
    }
  }
};

namespace detail {

template <int N, int NE, Horizon method, class Lights, class Material>
glm::vec3 gather_drawn(const Lights& clear, const Lights& across, const ReceiverFrame<typename Lights::Lanes>& frame,
                       const Material& coefficients, const Visibility& visible) {
  return gather_from<N, NE, Horizon::none>(clear, frame, coefficients, visible) +
         gather_from<N, NE, method>(across, frame, coefficients, visible);
}

}  // namespace detail

/// Outgoing radiance, RGB, at one of the receivers, as gather of hvl.hpp has it: `coefficients` are EvenSh or Zh, of
/// colours or numbers.
template <int N, int NE, Horizon method = Horizon::smoothstep, class Material>
glm::vec3 gather(const DrawnLights<NE>& lights, const Receiver& receiver, const Material& coefficients,
                 const Visibility& visible = {}) {
  // What is the same all about the normal needs no tangent.
  using Lanes = typename HvlCache<NE>::Lanes;
  const auto frame = symmetry_of<Material> == Symmetry::zonal ? detail::frame_of<Lanes>(receiver, glm::vec3(0.0F))
                                                              : detail::frame_of<Lanes>(receiver);
  glm::vec3 sum = detail::gather_drawn<N, NE, method>(lights.clear, lights.across, frame, coefficients, visible);
  for (const HvlCache<NE>* cache : {&lights.clear, &lights.across}) {
    if (const auto others = cache->anisotropic_lights(); others.packet_count() > 0) {
      sum += detail::gather_from<N, NE, method>(others, frame, detail::all_orders(coefficients), visible);
    }
  }
  return (glm::max)(sum, glm::vec3(0));
}

/// The same of an anisotropic material.
template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather(const DrawnLights<NE>& lights, const Receiver& receiver, const AnisotropicTable& material,
                 const Visibility& visible = {}) {
  using Lanes = typename HvlCache<NE>::Lanes;
  const detail::AnisotropicView eye(receiver.outgoing, receiver.normal, receiver.tangent);
  const auto frame = detail::frame_of<Lanes>(receiver, eye.tangent);
  const Sh<N, glm::vec3> coefficients = material.with_cosine<N>(eye.direction);
  const auto part = [&](const HvlCache<NE>& cache) {
    return detail::gather_from<N, NE, method>(cache.all_lights(), frame, coefficients, visible);
  };
  return (glm::max)(part(lights.clear) + part(lights.across), glm::vec3(0));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
