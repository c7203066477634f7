// GGX lobes and spherical Gaussians (SG): a lobe as an SG, and what it reflects of light that is one.
//
// A microfacet normal that turns by dh turns the reflection by 2 dh in the plane of incidence and by 2 cos dh across
// it. So light of sharpness lambda, seen in normals projected on the surface, is a Gaussian of variance 1 / (4 lambda)
// and 1 / (4 lambda cos^2); the distribution's own squared roughness, seen so, is p = a^2 / (1 - a^2). Twice the
// variances are added to it, and the sum P turned back to squared roughnesses 1 / (1 + q), q = 1 / P [1, 5.2]: the
// distribution, filtered. Taken on both sides of the surface, its visible normals reflect into the light's axis with
// the density
//
//   pdf = sqrt((1 + q_x) (1 + q_y)) / (4 pi (1 + q_x h_x^2 + q_y h_y^2)^2 length),
//   length^2 = (1 + q_x cos_o^2) / (1 + q_x),   h the half vector of the eye and the axis
//
// which [1] multiplies with the share of the product of lobe and light that is above the horizon. Three things are
// ours:
//
// - In place of 2 lambda stands 4 pi / (the SG's integral) - 1, which a sharp one is about: a mirror then reflects the
//   light's axis as bright as it is. Else up to 30 % brighter.
// - GGX falls slower than a Gaussian, and where both are as wide the sum of variances leaves their convolution's peak
//   24 % too high. P is larger by 1 + k / (1 + k)^2, k = p / (P - p): right in slopes to 5 %.
// - The share is all that [1] has for masking: of a rough surface it gives up to 20 % too much, or too little at
// grazing
//   angles, also of a point light. Here the BRDF over its own pdf, at the mean cosine of the share, multiplies it: then
//   a narrow light is exact at every roughness.
//
// [1] Y. Tokuyoshi, D. Ikeda, P. Kulkarni, T. Harada, Hierarchical Light Sampling with Accurate Spherical Gaussian
//     Lighting, SIGGRAPH Asia 2024, with its supplement.
// [2] J. Dupuy, A. Benyoub, Sampling Visible GGX Normals with Spherical Caps, HPG 2023.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "../lobe/gaussian_horizon.hpp"
#include "../lobe/gaussian_product.hpp"
#include "ggx.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The mirror direction of wo about the normal in the midst of the visible ones, the pole of the cap that [2] samples.
inline glm::vec3 dominant_reflection(float alpha, const glm::vec3& wo) {
  const float squared = alpha * alpha;
  const glm::vec3 normal =
      glm::normalize(glm::vec3(squared * wo.x, squared * wo.y, wo.z + ggx_projected_length(wo.z, alpha)));
  return 2.0F * glm::dot(normal, wo) * normal - wo;
}

/// The sharpness of the SG that a GGX lobe seen from above is, 2 / alpha^2 - 2 of normals, a quarter of it of
/// reflections.
inline float ggx_sharpness(float alpha) { return 0.5F * (1.0F - alpha) * (1.0F + alpha) / (alpha * alpha); }

/// The same of reflections along `axis`: by the Jacobian n_z / (4 cos) of their normal n [1, supplement].
inline GlossyGaussian ggx_gaussian(float alpha, const glm::vec3& wo) {
  const glm::vec3 axis = dominant_reflection(alpha, wo), half = axis + wo;
  const float squared_length = (std::max)(glm::dot(half, half), 1e-12F);  // 4 cos^2 about the normal half / |half|
  return {axis, ggx_sharpness(alpha) * 2.0F * half.z / squared_length};
}

/// q, above, along an axis: `light` is the light's own, which a mirror leaves.
template <class T>
ZONAL_INLINE inline T filtered_width(float alpha, const T& light) {
  const T rest = T((1.0F - alpha) * (1.0F + alpha)), own = T(alpha * alpha) * light, sum = own + rest;
  return rest * light * sum / (sum * sum + own * rest + T(1e-18L));
}

/// The density 1/sr, above, at the axis of light of that integral.
template <class T>
ZONAL_INLINE inline T filtered_pdf(float alpha, const glm::vec<3, T>& axis, const T& integral, const glm::vec3& wo) {
  const T light = maximum(T(4 * kPi) / integral - T(1), T(0)), cos2 = T(wo.z * wo.z);
  const T q_x = filtered_width(alpha, light), q_y = filtered_width(alpha, cos2 * light);
  const glm::vec<3, T> h = axis + glm::vec<3, T>(wo);
  const T x2 = h.x * h.x, y2 = h.y * h.y, inverse = T(1) / maximum(x2 + y2 + h.z * h.z, T(1e-12L));
  const T width = T(1) + (q_x * x2 + q_y * y2) * inverse;
  const T length = sqrt((T(1) + q_x * cos2) / (T(1) + q_x));
  return sqrt((T(1) + q_x) * (T(1) + q_y)) / (T(4 * kPi) * width * width * length);
}

/// What a GGX lobe without a Fresnel term reflects towards wo of light exp(sharpness (cos - 1)) about `axis`, and the
/// cosine at which its microfacets do. wo has y = 0 and z > 0.
template <class T>
struct GgxReflection {
  T amount, cos_difference;
};
template <class T>
ZONAL_INLINE inline GgxReflection<T> ggx_reflection(float alpha, const glm::vec<3, T>& axis, const T& sharpness,
                                                    const glm::vec3& wo) {
  const glm::vec3 mirror = dominant_reflection(alpha, wo);
  const auto both =
      product({T(mirror.x), T(mirror.y), T(mirror.z)}, T(ggx_sharpness(alpha)), {axis.x, axis.y, axis.z}, sharpness);
  const auto above = gaussian_above_horizon(both.axis[2], both.sharpness);
  const T cosine = above.mean_cosine(), length = T(ggx_projected_length(wo.z, alpha));
  const T masking = T(4) * length * cosine * ggx_visibility(cosine, T(wo.z), T(alpha));
  const T integral = gaussian_integral(sharpness);
  const glm::vec<3, T> peak(both.axis[0], both.axis[1], both.axis[2]);
  return {above.share * masking * filtered_pdf(alpha, axis, integral, wo) * integral,
          T(0.5L) * sqrt(half_vector(peak, glm::vec<3, T>(wo)).squared_length)};
}

}  // namespace detail

inline GlossyGaussian glossy_gaussian(const GgxBrdf& brdf, const glm::vec3& wo) {
  return detail::ggx_gaussian(detail::ggx_alpha(brdf.roughness), wo);
}

/// Greatest errors about the mirror direction, of the greatest reflection, seen from up to 75 degrees: 0.4 of light of
/// sharpness 1, and rough; 0.22 of 1e-3 and of 10, 0.17 of 100, 0.02 of 10000.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> gaussian_reflection(const GgxBrdf& brdf, const glm::vec<3, T>& axis,
                                                       const T& sharpness, const glm::vec3& wo) {
  const auto reflection = detail::ggx_reflection(detail::ggx_alpha(brdf.roughness), axis, sharpness, wo);
  return reflectance(brdf.fresnel, reflection.cos_difference) * reflection.amount;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
