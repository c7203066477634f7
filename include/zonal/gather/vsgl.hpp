// Virtual spherical Gaussian lights [1]: what many texels of a reflective shadow map reflect, as one Gaussian of
// position and one spherical Gaussian (SG) of direction, for the diffuse part and the glossy part apart.
//
// Building: an SG's sharpness lambda stands for the mean direction lambda / (lambda + 1) xi; means are averaged,
// weighted by the light that a texel reflects, and turned back, lambda = |mean| / (1 - |mean|) [1, 2.1]. Positions give
// their mean and variance. [1] takes the variance for that along one axis of a plane, where it is the sum over both;
// here it is halved. And
// a texel is no point but a disc of its light's radius: else a pair for few texels is as spiky as a point light.
//
// Shading: incoming light is the product of two SGs, of position and of direction, hence an SG [1, Eq. 7]; a diffuse
// receiver is an SG of sharpness 2 about its normal, a glossy lobe an anisotropic SG (ASG) [2] about the mirror
// direction. The products are integrated in closed form. Exponents such as |a + b| - a - b, differences of large
// numbers, are written as quotients: with c the cosine between the axes, -2 a b (1 - c) / (|a + b| + a + b).
//
// [1] Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussians, SIGGRAPH Asia 2015 Posters,
//     supplement.
// [2] K. Xu et al., Anisotropic Spherical Gaussians, SIGGRAPH Asia 2013.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "../scalar/math.hpp"
#include "light_cache.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The light of many texels: radiant intensity coefficient exp(sharpness (cos - 1)) about the axis, spread about
/// `position` with `variance` along each axis of a plane.
struct GaussianLight {
  glm::vec3 position, normal;  // means; the normal serves visibility only
  float variance;              // m^2
  glm::vec3 axis;              // unit
  float sharpness;
  glm::vec3 coefficient;  // W/sr, RGB
};

namespace detail {

/// The sharpness of the SG that stands for max(cos, 0) / pi [1, 1.1].
inline constexpr float diffuse_sharpness = 2.0F;

/// The integral of exp(sharpness (cos - 1)) over the sphere.
template <class T>
ZONAL_INLINE inline T gaussian_integral(const T& sharpness) {
  const T safe = maximum(sharpness, T(1e-3L));
  return T(2 * kPi) * (T(1) - exp(T(-2) * safe)) / safe;
}

/// The sharpness of a GGX lobe about the mirror direction, as an SG [1, 1.1].
inline float mirror_sharpness(float roughness, float cos_outgoing) {
  const float alpha = ggx_alpha(roughness);
  return 0.5F / (alpha * alpha * (std::max)(cos_outgoing, 1e-3F));
}

/// The sums of one component of a set of texels.
class GaussianSums {
 public:
  void add(const VirtualLight& texel, const glm::vec3& reflectance, const glm::vec3& axis, float sharpness) {
    const glm::dvec3 rgb(texel.flux * reflectance), at(texel.position);
    const double weight = (rgb.x + rgb.y + rgb.z) / 3.0;
    reflected_ += rgb;
    weight_ += weight;
    direction_ += weight * double(sharpness / (sharpness + 1.0F)) * glm::dvec3(axis);
    position_ += weight * at;
    square_ += weight * (glm::dot(at, at) + 0.5 * double(texel.radius) * double(texel.radius));
    normal_ += weight * glm::dvec3(texel.normal);
  }

  /// Nothing where nothing is reflected.
  std::optional<GaussianLight> light() const {
    if (!(weight_ > 0.0)) return std::nullopt;
    const glm::dvec3 position = position_ / weight_, direction = direction_ / weight_;
    const double trace = (std::max)(square_ / weight_ - glm::dot(position, position), 0.0);
    const double mean = glm::length(direction);
    GaussianLight light;
    light.position = glm::vec3(position);
    light.normal = glm::vec3(glm::normalize(normal_ + glm::dvec3(0.0, 0.0, 1e-30)));
    light.variance = float(0.5 * trace);
    light.axis = mean > 1e-9 ? glm::vec3(direction / mean) : light.normal;
    light.sharpness = float((std::min)(mean / (std::max)(1.0 - mean, 1e-9), 1e6));
    light.coefficient = glm::vec3(reflected_) / gaussian_integral(light.sharpness);
    return light;
  }

 private:
  glm::dvec3 reflected_{0.0}, direction_{0.0}, position_{0.0}, normal_{0.0};
  double weight_ = 0.0, square_ = 0.0;
};

/// Adds a lobe of a texel to the sums of its kind.
struct AddLobe {
  const VirtualLight& texel;
  GaussianSums &diffuse, &glossy;

  float cosine() const { return glm::dot(texel.normal, texel.to_primary); }
  void add_glossy(const glm::vec3& reflectance, float sharpness) const {
    const glm::vec3 mirror = 2.0F * cosine() * texel.normal - texel.to_primary;
    glossy.add(texel, reflectance, mirror, sharpness);
  }
  void operator()(const LambertBrdf& lobe) const { diffuse.add(texel, lobe.albedo, texel.normal, diffuse_sharpness); }
  void operator()(const ResidualBrdf& lobe) const {
    diffuse.add(texel, lobe.albedo * left_at(lobe, cosine()), texel.normal, diffuse_sharpness);
  }
  void operator()(const PhongBrdf& lobe) const { add_glossy(lobe.specular_albedo, lobe.exponent); }
  void operator()(const GgxBrdf& lobe) const {
    add_glossy(reflectance(lobe.fresnel, cosine()), mirror_sharpness(lobe.roughness, cosine()));
  }
  void operator()(const MeasuredBrdf& lobe) const {
    diffuse.add(texel, lobe.diffuse_albedo, texel.normal, diffuse_sharpness);
    add_glossy(lobe.specular_albedo, mirror_sharpness(lobe.roughness, cosine()));
  }
};

}  // namespace detail

/// A pair of lights, diffuse and glossy, for every block of `block` x `block` texels of the square map of `side` x
/// `side` lights, row by row; a single pair where block >= side; block is at least 1. Components that reflect nothing
/// are left out.
inline std::vector<GaussianLight> make_gaussian_lights(const VirtualLight* map, int side, int block) {
  std::vector<GaussianLight> lights;
  block = (std::max)(block, 1);
  for (int top = 0; top < side; top += block) {
    for (int left = 0; left < side; left += block) {
      detail::GaussianSums diffuse, glossy;
      for (int row = top; row < (std::min)(top + block, side); ++row) {
        for (int column = left; column < (std::min)(left + block, side); ++column) {
          const VirtualLight& texel = map[row * side + column];
          if (texel.brdf == nullptr || glm::dot(texel.normal, texel.to_primary) <= 0.0F) continue;
          for (const BrdfLobe& lobe : texel.brdf->lobes) std::visit(detail::AddLobe{texel, diffuse, glossy}, lobe);
        }
      }
      for (const detail::GaussianSums* sums : {&diffuse, &glossy}) {
        if (const std::optional<GaussianLight> light = sums->light()) lights.push_back(*light);
      }
    }
  }
  return lights;
}

/// A light as the kernel reads it, one lane or a packet of them.
template <class T>
struct GaussianRecord {
  T position[3], normal[3], axis[3], coefficient[3];
  T variance, sharpness;

  static constexpr int field_count = 14;
  ZONAL_INLINE T& field(int i) {
    if (i < 12) return (i < 3 ? position : i < 6 ? normal : i < 9 ? axis : coefficient)[i % 3];
    return i == 12 ? variance : sharpness;
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

/// 1 - cos of the angle between two unit vectors: from their difference, which does not cancel.
template <class T>
ZONAL_INLINE inline T one_minus_cosine(const T (&a)[3], const T (&b)[3]) {
  const T difference[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return T(0.5L) * dot3(difference, difference);
}

/// The product of two SGs of one pole each: axis and sharpness, and the logarithm of the coefficient.
template <class T>
struct GaussianProduct {
  T axis[3], sharpness, exponent;
};
template <class T>
ZONAL_INLINE inline GaussianProduct<T> product(const T (&a)[3], const T& a_sharpness, const T (&b)[3],
                                               const T& b_sharpness) {
  GaussianProduct<T> result;
  for (int i = 0; i < 3; ++i) result.axis[i] = a_sharpness * a[i] + b_sharpness * b[i];
  result.sharpness = maximum(sqrt(dot3(result.axis, result.axis)), T(1e-6L));
  const T inverse = T(1) / result.sharpness;
  for (T& component : result.axis) component = component * inverse;
  result.exponent =
      T(-2) * a_sharpness * b_sharpness * one_minus_cosine(a, b) / (result.sharpness + a_sharpness + b_sharpness);
  return result;
}

/// The light that comes in at x, [1] Eq. 7.
template <class T>
ZONAL_INLINE inline IncomingGaussian<T> incoming(const GaussianRecord<T>& light, const ReceiverFrame<T>& receiver) {
  const auto [direction, apart] = look_at(light, receiver);
  const T distance = minimum(apart, T(1e18L));  // its square is a number
  const T distance2 = distance * distance;
  // A point is a very small Gaussian.
  const T variance = maximum(light.variance, maximum(T(1e-6L) * distance2, T(1e-18L)));
  const T back[3] = {-light.axis[0], -light.axis[1], -light.axis[2]};
  const auto both = product(direction, distance2 / variance, back, light.sharpness);
  const T scale = exp(both.exponent) / (T(2 * kPi) * variance);
  IncomingGaussian<T> result;
  result.sharpness = both.sharpness;
  for (int i = 0; i < 3; ++i) {
    result.axis[i] = both.axis[i];
    result.coefficient[i] = light.coefficient[i] * scale;
  }
  return result;
}

/// The integral of an SG of coefficient 1 times that of a diffuse surface of albedo 1, which is normalised.
template <class T>
ZONAL_INLINE inline T diffuse_integral(const IncomingGaussian<T>& light, const T (&normal)[3]) {
  const T sharpness = T(diffuse_sharpness);
  const auto both = product(light.axis, light.sharpness, normal, sharpness);
  return exp(both.exponent) * gaussian_integral(both.sharpness) / gaussian_integral(sharpness);
}

/// A glossy lobe at a receiver as an ASG about the mirror direction, with what is left of the BRDF besides.
struct GlossyLobe {
  float in_plane, across;  // bandwidths, in the plane of incidence and across it
  float sharpness() const { return 2.0F * std::sqrt(in_plane * across); }
};

/// The half vector turns by half of what the incoming direction turns in the plane of incidence, and by 1 / (2 cos) of
/// it across: D = exp(-sin^2 / alpha^2) becomes an ASG.
inline GlossyLobe mirror_lobe(float roughness, float cos_outgoing) {
  const float alpha = ggx_alpha(roughness), cosine = (std::max)(cos_outgoing, 1e-3F);
  const float in_plane = 0.25F / (alpha * alpha);
  return {in_plane, in_plane / (cosine * cosine)};
}

/// The ASG of each model, and its height in a direction wi, cosine included, RGB. wo, wi: in the receiver's frame.
inline GlossyLobe glossy_lobe(const LambertBrdf&, const glm::vec3&) { return {0.0F, 0.0F}; }
inline GlossyLobe glossy_lobe(const ResidualBrdf&, const glm::vec3&) { return {0.0F, 0.0F}; }
inline GlossyLobe glossy_lobe(const PhongBrdf& brdf, const glm::vec3&) {
  return {0.5F * brdf.exponent, 0.5F * brdf.exponent};
}
inline GlossyLobe glossy_lobe(const GgxBrdf& brdf, const glm::vec3& wo) { return mirror_lobe(brdf.roughness, wo.z); }
inline GlossyLobe glossy_lobe(const MeasuredBrdf& brdf, const glm::vec3& wo) {
  return mirror_lobe(brdf.roughness, wo.z);
}

template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const LambertBrdf&, const glm::vec<3, T>&, const glm::vec3&) {
  return glm::vec<3, T>(T(0));
}
template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const ResidualBrdf&, const glm::vec<3, T>&, const glm::vec3&) {
  return glm::vec<3, T>(T(0));
}
template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3&) {
  const float normalisation = (brdf.exponent + 2.0F) / (2.0F * float(kPi));
  return glm::vec<3, T>(brdf.specular_albedo * normalisation) * maximum(wi.z, T(0));
}
template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  const T alpha = T(ggx_alpha(brdf.roughness)), cosine = maximum(wi.z, T(0));
  const T cos_difference = T(0.5L) * sqrt(half_vector(wi, glm::vec<3, T>(wo)).squared_length);
  const T height = ggx_visibility(cosine, T(wo.z), alpha) * cosine / (T(kPi) * alpha * alpha);
  return reflectance(brdf.fresnel, cos_difference) * height;
}
template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const MeasuredBrdf& brdf, const glm::vec<3, T>&, const glm::vec3& wo) {
  return glm::vec<3, T>(brdf.specular_albedo * (0.5F * glossy_lobe(brdf, wo).sharpness() / float(kPi)));
}

/// The albedo of all that is diffuse, seen from cos_outgoing.
inline glm::vec3 diffuse_reflectance(const Brdf& brdf, float cos_outgoing) {
  glm::vec3 sum = diffuse_albedo(brdf, cos_outgoing);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (const auto* measured = std::get_if<MeasuredBrdf>(&lobe)) sum += measured->diffuse_albedo;
  }
  return sum;
}

/// The integral of an SG of coefficient 1 times a lobe of the receiver's, RGB, [1, 3.2].
template <class T, class Lobe>
ZONAL_INLINE inline glm::vec<3, T> glossy_integral(const Lobe& brdf, const IncomingGaussian<T>& light,
                                                   const ReceiverFrame<T>& receiver, const glm::vec3& wo) {
  const GlossyLobe lobe = glossy_lobe(brdf, wo);
  const glm::vec<3, T> axis = to_local(light.axis, receiver.normal, receiver.tangent);
  // Along the mirror direction (-s, 0, c), along the other one of the plane of incidence (c, 0, s), and across.
  const T along = axis.z * T(wo.z) - axis.x * T(wo.x), beside = axis.x * T(wo.z) + axis.z * T(wo.x);
  const T half = T(0.5L) * light.sharpness, x = T(lobe.in_plane), y = T(lobe.across);
  const T exponent = -(x * half / (x + half) * beside * beside + y * half / (y + half) * axis.y * axis.y);
  const T overlap = T(kPi) * maximum(along, T(0)) * exp(exponent) / sqrt((x + half) * (y + half));

  // Where the product has its axis.
  const T sharpness = T(lobe.sharpness());
  glm::vec<3, T> peak = axis * light.sharpness + glm::vec<3, T>(glm::vec3(-wo.x, 0.0F, wo.z)) * sharpness;
  peak = peak * (T(1) / sqrt(maximum(peak.x * peak.x + peak.y * peak.y + peak.z * peak.z, T(1e-20L))));
  return glossy_height(brdf, peak, wo) * overlap;
}

}  // namespace detail

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB. `outgoing` is the
/// direction to the eye in the receiver's frame.
template <class T>
ZONAL_INLINE inline void vsgl_radiance(const GaussianRecord<T>& light, const ReceiverFrame<T>& receiver,
                                       const glm::vec3& outgoing, const Brdf& brdf, T (&radiance)[3]) {
  const auto gaussian = detail::incoming(light, receiver);
  glm::vec<3, T> reflected = glm::vec<3, T>(detail::diffuse_reflectance(brdf, outgoing.z)) *
                             detail::diffuse_integral(gaussian, receiver.normal);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (is_diffuse(lobe) || !(outgoing.z > 0.0F)) continue;  // seen from behind: no lobe
    reflected = reflected +
                std::visit([&](const auto& model)
                               ZONAL_INLINE { return detail::glossy_integral(model, gaussian, receiver, outgoing); },
                           lobe);
  }
  for (int c = 0; c < 3; ++c) radiance[c] = gaussian.coefficient[c] * reflected[c];
}

/// Outgoing radiance, RGB, at a receiver of material `brdf` from all lights of the cache: one bounce.
inline glm::vec3 gather_vsgl(const GaussianCache& cache, const Receiver& receiver, const Brdf& brdf,
                             const Visibility& visible = {}) {
  using Lanes = GaussianCache::Lanes;
  const auto frame = detail::frame_of<Lanes>(receiver);
  const glm::vec3 outgoing = detail::local_outgoing(receiver);
  return detail::sum_packets(cache, visible,
                             [&](const auto& light, auto& rgb) { vsgl_radiance(light, frame, outgoing, brdf, rgb); });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
