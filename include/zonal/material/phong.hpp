// A lobe about the mirror direction.
//
// [1] E. Lafortune, Y. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering",
//     report CW 197, KU Leuven, 1994.
#pragma once

#include <cmath>

#include "../lobe/gaussian_horizon.hpp"
#include "../lobe/gaussian_product.hpp"
#include "../scalar/vector3.hpp"
#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Normalised Phong lobe [1], f = specular_albedo (n + 2) / (2 pi) cos^n of the angle between wi and the
/// mirror direction of wo. specular_albedo: RGB in [0, 1], the albedo seen from the normal; exponent n: 0 to
/// 1e6.
struct PhongBrdf {
  glm::vec3 specular_albedo;
  float exponent;
};

namespace detail {

/// cos^n of the angle between wi and the mirror direction of wo, zero beyond a right angle.
/// For unit vectors the cosine is 1 - |wi - mirror|^2 / 2: the difference is exact near the peak, where
/// rounding the cosine itself would be amplified n times.
template <class T>
T phong_lobe(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo, T exponent) {
  const glm::vec<3, T> from_mirror(wi.x + wo.x, wi.y + wo.y, wi.z - wo.z);
  const T one_minus_cos =
      T(0.5) * (from_mirror.x * from_mirror.x + from_mirror.y * from_mirror.y + from_mirror.z * from_mirror.z);
  return one_minus_cos < T(1) ? std::exp(exponent * std::log1p(-one_minus_cos)) : T(0);
}

}  // namespace detail

template <class T>
glm::vec<3, T> evaluate(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    if (!detail::above_horizon(wi, wo)) return glm::vec<3, T>(T(0));
    const T exponent = T(brdf.exponent);
    const T normalisation = (exponent + T(2)) / (T(2) * T(kPi));  // [1]
    return glm::vec<3, T>(brdf.specular_albedo) * (normalisation * detail::phong_lobe(wi, wo, exponent));
  } else {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  }
}

inline float approximate_albedo(const PhongBrdf& brdf, const glm::vec3&) { return detail::mean(brdf.specular_albedo); }

/// [1]: cos = u^(1/(n+1)) about the mirror direction. 1 - cos is computed on its own, so that a high exponent
/// still has its directions apart.
inline glm::vec3 sample_lobe(const PhongBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  const float one_minus_cos = -std::expm1(std::log(u.x) / (brdf.exponent + 1.0F));
  const float sine = std::sqrt(one_minus_cos * (2.0F - one_minus_cos)), phi = 2.0F * float(kPi) * u.y;
  const float mirror[3] = {-wo.x, -wo.y, wo.z};
  float x[3], y[3];
  complete_frame(mirror, x, y);
  const auto along = [&](const float(&axis)[3]) { return glm::vec3(axis[0], axis[1], axis[2]); };
  return sine * std::cos(phi) * along(x) + sine * std::sin(phi) * along(y) + (1.0F - one_minus_cos) * along(mirror);
}

template <class T>
T lobe_pdf(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return (T(brdf.exponent) + T(1)) / (T(2) * T(kPi)) * detail::phong_lobe(wi, glm::vec<3, T>(wo), T(brdf.exponent));
  } else {
    const auto pdf = [&](const auto& i, const auto& o) { return glm::vec<3, lane_t<T>>(lobe_pdf(brdf, i, o)); };
    return detail::by_lanes(wi, glm::vec<3, T>(wo), pdf).x;
  }
}

inline glm::vec3 diffuse_albedo(const PhongBrdf&, float) { return glm::vec3(0.0F); }
inline glm::vec3 glossy_albedo(const PhongBrdf& brdf, float) { return brdf.specular_albedo; }
inline GlossyLobe glossy_lobe(const PhongBrdf& brdf, float) { return {0.5F * brdf.exponent, 0.5F * brdf.exponent}; }

template <class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3&) {
  const float normalisation = (brdf.exponent + 2.0F) / (2.0F * float(kPi));
  return glm::vec<3, T>(brdf.specular_albedo * normalisation) * maximum(wi.z, T(0));
}

/// cos^n about as the Gaussian of the same integral.
inline GlossyGaussian glossy_gaussian(const PhongBrdf& brdf, const glm::vec3& wo) {
  return {{-wo.x, -wo.y, wo.z}, brdf.exponent + 1.0F};
}

/// Greatest error, of the greatest reflection: 0.007 for exponents from 60, 0.065 from 5.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> gaussian_reflection(const PhongBrdf& brdf, const glm::vec<3, T>& axis,
                                                       const T& sharpness, const glm::vec3& wo) {
  const auto both =
      detail::product({T(-wo.x), T(-wo.y), T(wo.z)}, T(brdf.exponent + 1.0F), {axis.x, axis.y, axis.z}, sharpness);
  const T integral = detail::gaussian_integral(both.sharpness) *
                     detail::gaussian_above_horizon(both.axis[2], both.sharpness).cosine * exp(both.exponent);
  return glm::vec<3, T>(brdf.specular_albedo * ((brdf.exponent + 2.0F) / (2.0F * float(kPi)))) * integral;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
