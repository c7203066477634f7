// The point that receives light from virtual lights, and what stands between.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/function_ref.hpp"
#include "../scalar/long_sum.hpp"
#include "../scalar/packet.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A point that is seen: `outgoing` is the unit direction to the eye, on the normal's side. The tangent, the x axis of
/// the material's own frame, matters to anisotropic materials alone; it need not be of unit length or normal to the
/// normal, and where it says nothing any direction of the surface is taken.
struct Receiver {
  glm::vec3 position, normal, outgoing;
  glm::vec3 tangent{0};
};

/// A frame about a normal in which a fixed direction has phi = 0.
template <class T>
struct ReceiverFrame {
  T position[3], normal[3], tangent[3];
};

/// Where a light stands, seen from the receiver.
template <class T>
struct LightDirection {
  T direction[3];  // unit, from the receiver to the light
  T distance, inverse;
};

template <class Record, class T>
ZONAL_INLINE inline LightDirection<T> look_at(const Record& light, const ReceiverFrame<T>& receiver) {
  const T to_light[3] = {light.position[0] - receiver.position[0], light.position[1] - receiver.position[1],
                         light.position[2] - receiver.position[2]};
  const T distance = sqrt(maximum(detail::dot3(to_light, to_light), T(1e-30L)));
  const T inverse = T(1) / distance;
  return {{to_light[0] * inverse, to_light[1] * inverse, to_light[2] * inverse}, distance, inverse};
}

/// Is a light, at this position and with this normal, seen from the receiver? It is asked for each light that would
/// contribute; an empty one lets all pass. It refers to a callable that outlives the gather: pass a lambda. A ray to
/// the light's centre is what [1, 5.1] does.
///
/// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
using Visibility = FunctionRef<bool(const glm::vec3& position, const glm::vec3& normal)>;

namespace detail {

/// The unit vector of v's part in the plane of the normal; any one of that plane where v is the normal.
template <class T>
ZONAL_INLINE inline void tangent_towards(const T (&normal)[3], const T (&v)[3], T (&tangent)[3]) {
  const T along = dot3(v, normal);
  const T flat[3] = {v[0] - along * normal[0], v[1] - along * normal[1], v[2] - along * normal[2]};
  // Of the x and the y axis the one that is farther from the normal, times the normal.
  const auto is_x = abs(normal[0]) < T(0.5L);
  const T other[3] = {select(is_x, T(0), -normal[2]), select(is_x, normal[2], T(0)),
                      select(is_x, -normal[1], normal[0])};
  const auto has_direction = T(1e-12L) < dot3(flat, flat);
  for (int i = 0; i < 3; ++i) tangent[i] = select(has_direction, flat[i], other[i]);
  const T length = sqrt(dot3(tangent, tangent));
  for (T& x : tangent) x = x / length;
}
inline glm::vec3 tangent_towards(const glm::vec3& normal, const glm::vec3& v) {
  float tangent[3];
  tangent_towards({normal.x, normal.y, normal.z}, {v.x, v.y, v.z}, tangent);
  return {tangent[0], tangent[1], tangent[2]};
}

/// A direction in the frame of a normal and a tangent, x along the tangent.
inline glm::vec3 in_frame(const glm::vec3& v, const glm::vec3& normal, const glm::vec3& tangent) {
  return {glm::dot(v, tangent), glm::dot(v, glm::cross(normal, tangent)), glm::dot(v, normal)};
}

/// The frame in which the direction `fixed`, given in that of a normal and a tangent, has phi = 0: its tangent. As
/// anisotropic_table.hpp has it, also where `fixed` is the normal.
inline glm::vec3 turned_tangent(const glm::vec3& fixed, const glm::vec3& normal, const glm::vec3& tangent) {
  const float azimuth = std::atan2(fixed.y, fixed.x);
  return std::cos(azimuth) * tangent + std::sin(azimuth) * glm::cross(normal, tangent);
}

/// How a surface with a tangent of its own, as anisotropic ones have, sees a direction v of world space: in the frame
/// of that tangent; and the tangent of the frame in which v has phi = 0.
struct AnisotropicView {
  glm::vec3 direction, tangent;

  AnisotropicView(const glm::vec3& v, const glm::vec3& normal, const glm::vec3& surface_tangent) {
    const glm::vec3 own = tangent_towards(normal, surface_tangent);
    direction = in_frame(v, normal, own);
    tangent = turned_tangent(direction, normal, own);
  }
};

/// The receiver's frame of that tangent, the same in all lanes.
template <class T>
ReceiverFrame<T> frame_of(const Receiver& receiver, const glm::vec3& tangent) {
  ReceiverFrame<T> frame;
  for (int i = 0; i < 3; ++i) {
    frame.position[i] = T(receiver.position[i]);
    frame.normal[i] = T(receiver.normal[i]);
    frame.tangent[i] = T(tangent[i]);
  }
  return frame;
}

/// The frame in which the eye has phi = 0.
template <class T>
ReceiverFrame<T> frame_of(const Receiver& receiver) {
  return frame_of<T>(receiver, tangent_towards(receiver.normal, receiver.outgoing));
}

/// Takes from what one packet of all lights contributes that of the lights that the receiver does not see.
template <class Lights, class T>
void hide_unseen(const Lights& all, int index, const Visibility& visible, T (&radiance)[3]) {
  const auto lights = all.packet(index);
  for (int lane = 0; lane < T::width; ++lane) {
    const glm::vec3 rgb(radiance[0][lane], radiance[1][lane], radiance[2][lane]);
    if (rgb == glm::vec3(0.0F)) continue;
    const auto vector = [&](const T(&v)[3]) { return glm::vec3(v[0][lane], v[1][lane], v[2][lane]); };
    if (visible(vector(lights.position), vector(lights.normal))) continue;
    for (T& channel : radiance) channel.set(lane, 0);
  }
}

/// The sum of radiance(record, to[3]) over all packets that `lights` holds: long_sum.hpp, of which a term is a packet.
template <class Lights, class Radiance>
ZONAL_INLINE inline glm::vec3 sum_packets(const Lights& lights, const Visibility& visible, const Radiance& radiance) {
  using Lanes = typename Lights::Lanes;
  CompensatedSum<Lanes> total[3];
  const int count = lights.packet_count();
  for (int first = 0; first < count; first += terms_in_block) {
    Lanes sum[3] = {Lanes(0), Lanes(0), Lanes(0)};
    const int last = (std::min)(first + terms_in_block, count);
    for (int i = first; i < last; ++i) {
      Lanes rgb[3];
      radiance(lights.packet(i), rgb);
      if (visible) {  // what is passed on would stand in memory all the time: a copy, and the packet once more
        Lanes seen[3] = {rgb[0], rgb[1], rgb[2]};
        hide_unseen(lights, i, visible, seen);
        for (int c = 0; c < 3; ++c) sum[c] = sum[c] + seen[c];
      } else {
        for (int c = 0; c < 3; ++c) sum[c] = sum[c] + rgb[c];
      }
    }
    for (int c = 0; c < 3; ++c) total[c].add(sum[c]);
  }
  return {total[0].value().sum(), total[1].value().sum(), total[2].value().sum()};
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
