// Virtual spherical lights [1]: a light's power comes from a sphere, and is integrated over the cap that the sphere
// covers by sampling.
//
//   L_o(x) = sum_j Phi_j / (pi r^2) integral over the cap of f_x(w, wo) cos_x f_y(w_l, -w) cos_y dw
//
// Two strategies share the samples and are joined by the balance heuristic: directions uniform in the cap, and
// directions by the receiver's BRDF. The latter know nothing of the light, so they are drawn once for all lights; a
// receiver that is diffuse has no use for them, and all its samples go to the cap.
//
// [1] Hasan, Krivanek, Walter, Bala, Virtual spherical lights for many-light rendering of glossy scenes, SIGGRAPH Asia
//     2009.
#pragma once

#include <algorithm>
#include <cmath>

#include "../lobe/cap.hpp"
#include "../material/sampling.hpp"
#include "light_cache.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Samples per light that gather_vsl can take.
inline constexpr int kMaxVslSamples = 1024;

namespace detail {

/// What of one receiver's samples all lights share.
struct VslSamples {
  struct ByBrdf {
    glm::vec3 direction, reflected;  // world; f cos, 1/sr
    float density;                   // 1/sr
  };
  struct InCap {
    float u, cos_phi, sin_phi;
  };
  int brdf_count = 0, cap_count = 0;
  ByBrdf by_brdf[std::size_t{kMaxVslSamples / 2}];
  InCap in_cap[std::size_t{kMaxVslSamples}];
};

inline float fraction(float x) { return x - std::floor(x); }

/// Stratified: the k-th of n in the k-th interval, and golden-ratio sequences in the other dimensions.
template <class Uniform>
void draw_vsl_samples(const Receiver& receiver, const Brdf& brdf, int samples, Uniform& uniform, VslSamples& result) {
  constexpr float golden = 0.61803399F, plastic = 0.75487767F;
  const bool is_diffuse = glossy_part(brdf).lobes.empty();
  result.brdf_count = is_diffuse ? 0 : samples / 2;
  result.cap_count = samples - result.brdf_count;

  const glm::vec3 normal = receiver.normal, tangent = brdf_tangent(receiver, brdf);
  const glm::vec3 bitangent = glm::cross(normal, tangent), outgoing = in_frame(receiver.outgoing, normal, tangent);
  const float lobe_shift = uniform(), phi_shift = uniform();
  int drawn = 0;
  for (int k = 0; k < result.brdf_count; ++k) {
    const float u = (float(k) + uniform()) / float(result.brdf_count);
    const auto sample = zonal::sample(brdf, outgoing, fraction(lobe_shift + golden * float(k)),
                                      {u, fraction(phi_shift + plastic * float(k))});
    if (sample.pdf <= 0.0F || sample.direction.z <= 0.0F) continue;
    const glm::vec3 world = sample.direction.x * tangent + sample.direction.y * bitangent + sample.direction.z * normal;
    result.by_brdf[drawn++] = {world, evaluate(brdf, sample.direction, outgoing) * sample.direction.z, sample.pdf};
  }
  // A sample that no direction came of is one that reflects nothing: the count stays that of what was tried.
  for (int k = drawn; k < result.brdf_count; ++k) result.by_brdf[k] = {normal, glm::vec3(0.0F), 1.0F};

  const float u_shift = uniform(), cap_phi_shift = uniform();
  for (int k = 0; k < result.cap_count; ++k) {
    const float phi = 2.0F * float(kPi) * fraction(cap_phi_shift + golden * float(k));
    result.in_cap[k] = {(float(k) + u_shift) / float(result.cap_count), std::cos(phi), std::sin(phi)};
  }
}

/// The cap that a light covers, and how to weigh a direction in it.
template <class T>
struct VslCap {
  T versine;      // 1 - cos of the half angle
  T solid_angle;  // sr
  T per_area;     // solid_angle / (pi r^2), without its 0 / 0 for a point
  T cap_count;    // samples in the cap
  T brdf_count;   // samples by the BRDF
  T direction[3];

  /// The balance heuristic's weight over the density, cap_count / solid_angle + brdf_count brdf_density, and over the
  /// area of the light's disc.
  ZONAL_INLINE T weight(const T& brdf_density) const {
    return per_area / (cap_count + brdf_count * (brdf_density * solid_angle));
  }
  /// By the chord, 2 - 2 cos, for the cosines of a small cap are all alike.
  ZONAL_INLINE mask_t<T> holds(const T (&w)[3]) const {
    const T chord[3] = {w[0] - direction[0], w[1] - direction[1], w[2] - direction[2]};
    return dot3(chord, chord) < versine + versine;
  }
};

}  // namespace detail

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `outgoing` is the
/// direction to the eye in the receiver's frame. A receiver inside the sphere sees a hemisphere. A light of radius 0 is
/// a point light, by the samples in its cap.
template <class T>
ZONAL_INLINE inline void vsl_radiance(const LightRecord<T>& light, const Brdf& glossy, const ReceiverFrame<T>& receiver,
                                      const glm::vec3& outgoing, const Brdf& brdf, const detail::VslSamples& samples,
                                      T (&radiance)[3]) {
  const LightDirection<T> to_light = look_at(light, receiver);
  const auto shape = SphericalCap<T>::from_sphere(to_light.distance, light.radius);
  const T versine = shape.sin_angle * shape.sin_angle / (T(1) + shape.cos_angle);
  const T apart = maximum(to_light.distance, light.radius);  // sin a = r / apart
  detail::VslCap<T> cap{versine,
                        T(2 * kPi) * versine,
                        T(2) / (maximum(apart * apart, T(1e-30L)) * (T(1) + shape.cos_angle)),
                        T(float(samples.cap_count)),
                        T(float(samples.brdf_count)),
                        {}};
  for (int i = 0; i < 3; ++i) cap.direction[i] = to_light.direction[i];
  for (int c = 0; c < 3; ++c) radiance[c] = T(0);

  // Adds f cos at the receiver times what the light sends against w.
  const auto add = [&](const T(&w)[3], const glm::vec<3, T>& reflected, const T& weight) ZONAL_INLINE {
    T sent[3];
    detail::reflected_flux(light, glossy, w, sent);
    const T cosine = maximum(T(0), -detail::dot3(w, light.normal)) * weight;
    for (int c = 0; c < 3; ++c) radiance[c] = radiance[c] + sent[c] * reflected[c] * cosine;
  };

  for (int k = 0; k < samples.brdf_count; ++k) {
    const auto& sample = samples.by_brdf[k];
    const T w[3] = {T(sample.direction.x), T(sample.direction.y), T(sample.direction.z)};
    const mask_t<T> inside = cap.holds(w);
    if (!AnyLane<T>::of(inside)) continue;
    add(w, glm::vec<3, T>(sample.reflected), select(inside, cap.weight(T(sample.density)), T(0)));
  }

  T x[3], y[3];
  complete_frame(to_light.direction, x, y);
  const glm::vec<3, T> local_outgoing(outgoing);
  for (int k = 0; k < samples.cap_count; ++k) {
    const auto& sample = samples.in_cap[k];
    T u = T(sample.u) + light.shift;
    u = select(u < T(1), u, u - T(1));
    const T one_minus_cos = u * versine, sine = sqrt(one_minus_cos * (T(2) - one_minus_cos));
    const T along_x = sine * (light.turn[0] * T(sample.cos_phi) - light.turn[1] * T(sample.sin_phi));
    const T along_y = sine * (light.turn[1] * T(sample.cos_phi) + light.turn[0] * T(sample.sin_phi));
    T w[3];
    for (int i = 0; i < 3; ++i) {
      w[i] = along_x * x[i] + along_y * y[i] + (T(1) - one_minus_cos) * to_light.direction[i];
    }
    const glm::vec<3, T> incoming = detail::to_local(w, receiver.normal, receiver.tangent);
    const T density = samples.brdf_count > 0 ? pdf(brdf, incoming, outgoing) : T(0);
    add(w, evaluate(brdf, incoming, local_outgoing) * maximum(T(0), incoming.z), cap.weight(density));
  }
}

/// Outgoing radiance, RGB, at a receiver of material `brdf` from all lights of the cache: one bounce. `samples` per
/// light, of which 1 to kMaxVslSamples are taken; uniform() returns random floats in [0, 1). Its mean over them is the
/// formula above.
template <class Uniform>
glm::vec3 gather_vsl(const LightCache& cache, const Receiver& receiver, const Brdf& brdf, int samples,
                     Uniform&& uniform, const Visibility& visible = {}) {
  using Lanes = PacketArray<LightRecord>::Lanes;
  detail::VslSamples drawn;
  detail::draw_vsl_samples(receiver, brdf, std::clamp(samples, 1, kMaxVslSamples), uniform, drawn);
  const glm::vec3 tangent = detail::brdf_tangent(receiver, brdf);
  const auto frame = detail::frame_of<Lanes>(receiver, tangent);
  const glm::vec3 outgoing = detail::in_frame(receiver.outgoing, receiver.normal, tangent);
  return detail::sum_groups(cache, visible, [&](const LightCache::Group& group, const auto& light, auto& rgb) {
    vsl_radiance(light, group.glossy, frame, outgoing, brdf, drawn, rgb);
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
