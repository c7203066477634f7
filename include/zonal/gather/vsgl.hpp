// Virtual spherical Gaussian lights [1] at a receiver; gaussian_lights.hpp makes them.
//
// Incoming light is the product of two SGs, of position and of direction, hence an SG [1, Eq. 7]; a diffuse
// receiver is an SG of sharpness 2 about its normal, a glossy lobe an anisotropic SG (ASG) [2] about the mirror
// direction. The products are integrated in closed form. Anisotropic materials are taken for isotropic ones.
//
// That is the method of 2015. By the formulas of 2024 a diffuse receiver is the clamped cosine itself [3, section 4],
// and a glossy lobe is filtered by the light [3, section 5], material/ggx_gaussian.hpp. It takes 1.6 times as long of a
// diffuse receiver, 2.5 of a glossy one.
//
// [1] Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussians, SIGGRAPH Asia 2015 Posters,
//     supplement.
// [2] K. Xu et al., Anisotropic Spherical Gaussians, SIGGRAPH Asia 2013.
// [3] Y. Tokuyoshi, D. Ikeda, P. Kulkarni, T. Harada, Hierarchical Light Sampling with Accurate Spherical Gaussian
//     Lighting, SIGGRAPH Asia 2024.
#pragma once

#include <cmath>
#include <vector>

#include "../lobe/gaussian_product.hpp"
#include "../scalar/math.hpp"
#include "gaussian_lights.hpp"
#include "light_cache.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A light as the kernel reads it, one lane or a packet of them.
template <class T>
struct GaussianRecord {
  T position[3], normal[3], axis[3], coefficient[3];
  T variance, sharpness;

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(normal), visit(axis), visit(coefficient), visit(variance), visit(sharpness);
  }
};

/// The lights in packets.
class GaussianCache {
 public:
  using Lanes = PacketArray<GaussianRecord>::Lanes;

  GaussianCache() = default;
  explicit GaussianCache(const std::vector<GaussianLight>& lights) {
    for (const GaussianLight& light : lights) {
      GaussianRecord<float> record;
      for (int i = 0; i < 3; ++i) {
        record.position[i] = light.position[i];
        record.normal[i] = light.normal[i];
        record.axis[i] = light.axis[i];
        record.coefficient[i] = light.coefficient[i];
      }
      record.variance = light.variance;
      record.sharpness = light.sharpness;
      records_.append(record);
    }
  }

  int size() const { return records_.size(); }
  int packet_count() const { return records_.packet_count(); }
  ZONAL_INLINE GaussianRecord<Lanes> packet(int index) const { return records_.packet(index); }

 private:
  PacketArray<GaussianRecord> records_;
};

namespace detail {

/// coefficient exp(sharpness (cos - 1)) about the axis.
template <class T>
struct IncomingGaussian {
  T axis[3], sharpness, coefficient[3];
};

/// The light that comes in at x, [1] Eq. 7.
template <class T>
ZONAL_INLINE inline IncomingGaussian<T> incoming(const GaussianRecord<T>& light, const ReceiverFrame<T>& receiver) {
  const LightDirection<T> to_light = look_at(light, receiver);
  const T distance = minimum(to_light.distance, T(1e18L));  // its square is a number
  const T distance2 = distance * distance;
  // A point is a very small Gaussian.
  const T variance = maximum(light.variance, maximum(T(1e-6L) * distance2, T(1e-18L)));
  const T back[3] = {-light.axis[0], -light.axis[1], -light.axis[2]};
  const auto both = product(to_light.direction, distance2 / variance, back, light.sharpness);
  const T scale = exp(both.exponent) / (T(2 * kPi) * variance);
  IncomingGaussian<T> result;
  result.sharpness = both.sharpness;
  for (int i = 0; i < 3; ++i) {
    result.axis[i] = both.axis[i];
    result.coefficient[i] = light.coefficient[i] * scale;
  }
  return result;
}

/// The integral of an SG of coefficient 1 times what a diffuse surface of albedo 1 makes of it: another SG, normalised
/// [1, 1.1]; or the clamped cosine over pi, within 0.0023 / pi of the SG's own integral.
template <Vsgl formulas, class T>
ZONAL_INLINE inline T diffuse_integral(const IncomingGaussian<T>& light, const T (&normal)[3]) {
  if constexpr (formulas == Vsgl::of_2024) {
    const T above = gaussian_above_horizon(dot3(light.axis, normal), light.sharpness).cosine;
    return T(1 / kPi) * above * gaussian_integral(light.sharpness);
  } else {
    const T sharpness = T(diffuse_sharpness<formulas>);
    const auto both = product(light.axis, light.sharpness, normal, sharpness);
    return exp(both.exponent) * gaussian_integral(both.sharpness) / gaussian_integral(sharpness);
  }
}

/// The albedo of all that is diffuse, seen from cos_outgoing.
inline glm::vec3 diffuse_reflectance(const Brdf& brdf, float cos_outgoing) {
  glm::vec3 sum(0.0F);
  for (const BrdfLobe& lobe : brdf.lobes) sum += diffuse_albedo(lobe, cos_outgoing);
  return sum;
}

/// The integral of an SG exp(sharpness (cos - 1)) about `axis` times a lobe of the receiver's, an ASG, RGB [1, 3.2].
template <class T, class Lobe>
ZONAL_INLINE inline glm::vec<3, T> mirror_integral(const Lobe& brdf, const glm::vec<3, T>& axis, const T& sharpness,
                                                   const glm::vec3& wo) {
  const GlossyLobe lobe = glossy_lobe(brdf, wo.z);
  // Along the mirror direction (-s, 0, c), along the other one of the plane of incidence (c, 0, s), and across.
  const T along = axis.z * T(wo.z) - axis.x * T(wo.x), beside = axis.x * T(wo.z) + axis.z * T(wo.x);
  const T half = T(0.5L) * sharpness, x = T(lobe.in_plane), y = T(lobe.across);
  const T exponent = -(x * half / (x + half) * beside * beside + y * half / (y + half) * axis.y * axis.y);
  const T overlap = T(kPi) * maximum(along, T(0)) * exp(exponent) / sqrt((x + half) * (y + half));

  // Where the product has its axis.
  const T own = T(lobe.sharpness());
  glm::vec<3, T> peak = axis * sharpness + glm::vec<3, T>(glm::vec3(-wo.x, 0.0F, wo.z)) * own;
  peak = peak * (T(1) / sqrt(maximum(peak.x * peak.x + peak.y * peak.y + peak.z * peak.z, T(1e-20L))));
  return glossy_height(brdf, peak, wo) * overlap;
}

/// The same by either set of formulas.
template <Vsgl formulas, class T, class Lobe>
ZONAL_INLINE inline glm::vec<3, T> glossy_integral(const Lobe& brdf, const IncomingGaussian<T>& light,
                                                   const ReceiverFrame<T>& receiver, const glm::vec3& wo) {
  const glm::vec<3, T> axis = to_local(light.axis, receiver.normal, receiver.tangent);
  if constexpr (formulas == Vsgl::of_2024) {
    return gaussian_reflection(brdf, axis, light.sharpness, wo);
  } else {
    return mirror_integral(brdf, axis, light.sharpness, wo);
  }
}

}  // namespace detail

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `outgoing` is the
/// direction to the eye in the receiver's frame.
template <Vsgl formulas, class T>
ZONAL_INLINE inline void vsgl_radiance(const GaussianRecord<T>& light, const ReceiverFrame<T>& receiver,
                                       const glm::vec3& outgoing, const Brdf& brdf, T (&radiance)[3]) {
  const auto gaussian = detail::incoming(light, receiver);
  glm::vec<3, T> reflected = glm::vec<3, T>(detail::diffuse_reflectance(brdf, outgoing.z)) *
                             detail::diffuse_integral<formulas>(gaussian, receiver.normal);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (is_diffuse(lobe) || !(outgoing.z > 0.0F)) continue;  // seen from behind: no lobe
    reflected =
        reflected +
        std::visit([&](const auto& model)
                       ZONAL_INLINE { return detail::glossy_integral<formulas>(model, gaussian, receiver, outgoing); },
                   lobe);
  }
  for (int c = 0; c < 3; ++c) radiance[c] = gaussian.coefficient[c] * reflected[c];
}

/// Outgoing radiance, RGB, at a receiver of material `brdf` from all lights of the cache: one bounce. The lights are to
/// be made by the same formulas.
template <Vsgl formulas = Vsgl::of_2015>
glm::vec3 gather_vsgl(const GaussianCache& cache, const Receiver& receiver, const Brdf& brdf,
                      const Visibility& visible = {}) {
  using Lanes = GaussianCache::Lanes;
  const auto frame = detail::frame_of<Lanes>(receiver);
  const glm::vec3 outgoing = detail::local_outgoing(receiver);
  return detail::sum_packets(cache, visible, [&](const auto& light, auto& rgb) {
    vsgl_radiance<formulas>(light, frame, outgoing, brdf, rgb);
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
