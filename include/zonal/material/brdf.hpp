// Analytic BRDF models: Lambert, Phong, GGX, and sums of them.
//
// Directions are unit vectors in the local frame, z being the surface normal; wi points towards the light, wo
// towards the eye. A BRDF f(wi, wo) is in 1/sr, one value per RGB channel, reciprocal (measured materials may not be),
// and exactly zero when either direction is at or below the horizon. The models here are isotropic: f depends on the
// azimuths through their difference. Measured materials may be anisotropic.
//
// Each kernel is a template on its scalar T (float, double, long double, or a packet of them); the parameters of
// a model are floats, and are widened, so that a projection done in double is limited by the model and not by its
// evaluation. What has no packet form, Phong and measured materials, is evaluated lane by lane.
//
// [1] B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet Models for Refraction through Rough Surfaces",
//     EGSR 2007.
// [2] E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014.
// [3] E. Lafortune, Y. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering",
//     report CW 197, KU Leuven, 1994.
// [4] M. Born, E. Wolf, "Principles of Optics", 7th edition, 1999, sections 1.5.2 and 14.2.
// [5] C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", CGF 13(3), 1994.
// [6] C. Kelemen, L. Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model with Importance Sampling",
//     Eurographics 2001 short presentations.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Perfectly diffuse reflection, f = albedo / pi. albedo: RGB in [0, 1].
struct LambertBrdf {
  glm::vec3 albedo;
};

/// Normalised Phong lobe [3], f = specular_albedo (n + 2) / (2 pi) cos^n of the angle between wi and the
/// mirror direction of wo. specular_albedo: RGB in [0, 1], the albedo seen from the normal; exponent n: 0 to
/// 1e6.
struct PhongBrdf {
  glm::vec3 specular_albedo;
  float exponent;
};

/// Exact Fresnel reflectance of a metal of index eta + i k (the medium above has index 1), per RGB channel.
/// eta > 0, k >= 0.
struct ConductorFresnel {
  glm::vec3 eta, k;
};

/// Exact Fresnel reflectance of a dielectric. eta > 0: its index over that of the medium above; below 1,
/// total internal reflection is included.
struct DielectricFresnel {
  float eta;
};

/// Schlick's approximation [5]. f0: RGB reflectance at normal incidence, in [0, 1].
struct SchlickFresnel {
  glm::vec3 f0;
};

using Fresnel = std::variant<ConductorFresnel, DielectricFresnel, SchlickFresnel>;

/// Isotropic GGX microfacets [1] with the height-correlated Smith masking-shadowing function [2] and single
/// scattering, which loses up to 69 % of the energy at roughness 1; energy.hpp has the rest. roughness is GGX's alpha
/// itself (no squaring), 0.001 to 1; below 1e-4 it counts as that, above 1 as 1.
struct GgxBrdf {
  float roughness;
  Fresnel fresnel;
};

/// An isotropic BRDF in 1/sr, as any function of (wi, wo) that is zero at and below the horizon.
using BrdfFunction = std::function<glm::dvec3(const glm::dvec3&, const glm::dvec3&)>;

/// A quadrature over the hemisphere that suits a BRDF seen from wo: nodes(wo, level, visit) calls visit(wi, f(wi, wo)
/// times the node's solid angle), level 0 to brdf_node_levels - 1 from coarse to fine. An isotropic BRDF's are for
/// integrals with functions of wi that are even about the plane of wo.
using BrdfNodes = std::function<void(const glm::dvec3& wo, int level,
                                     const std::function<void(const glm::dvec3& wi, const glm::dvec3& weighted)>&)>;
inline constexpr int brdf_node_levels = 4;

/// A measured material; measured.hpp makes it. The function is the material; beside it stand a diffuse and a GGX lobe
/// of about its size, to choose directions by, and for virtual lights that are Gaussians; and its own quadrature, for
/// projections, where it has one. It need not be reciprocal: f(wi, wo), where wo is the direction the light leaves in,
/// may differ from f(wo, wi).
struct MeasuredBrdf {
  std::shared_ptr<const BrdfFunction> function;
  glm::vec3 diffuse_albedo, specular_albedo;
  float roughness;
  std::shared_ptr<const BrdfNodes> nodes{};
  bool isotropic = true;  // else it is to be asked in the surface's own frame: directions with x along its tangent
};

/// A diffuse lobe that reflects of what another lobe leaves the share `albedo`, RGB in [0, 1] [6]:
///
///   f = albedo left(wi) left(wo) / (pi mean),   mean = integral of left(wi) cos / pi dwi
///
/// It is reciprocal, and its albedo seen from wo is albedo left(wo), so that the two lobes together reflect at most
/// all. energy.hpp makes it, for a body under a coat and for what light does between microfacets.
struct ResidualBrdf {
  static constexpr int degree = 13;

  glm::vec3 albedo, mean;
  float scale;                      // of the cosine: t = 2 sqrt((1 + scale) cos / (scale + cos)) - 1
  glm::vec3 chebyshev[degree + 1];  // of left, the other lobe's albedo taken from 1, by polynomials in t
};

using BrdfLobe = std::variant<LambertBrdf, PhongBrdf, GgxBrdf, MeasuredBrdf, ResidualBrdf>;

/// A material: the sum of its lobes. Nothing checks that the sum conserves energy: Lambert beside GGX does not, where
/// energy.hpp has a material that does.
struct Brdf {
  std::vector<BrdfLobe> lobes;
};

namespace detail {

/// The mask of lanes where both directions are above the horizon.
template <class T>
ZONAL_INLINE inline mask_t<T> above_horizon(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  return minimum(wi.z, wo.z) > T(0);
}

/// rgb where the mask holds, black elsewhere.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> or_black(const mask_t<T>& mask, const glm::vec<3, T>& rgb) {
  return {select(mask, rgb.x, T(0)), select(mask, rgb.y, T(0)), select(mask, rgb.z, T(0))};
}

/// f(wi, wo), an RGB value of built-in scalars, at every lane of a packet.
template <class T, class F>
glm::vec<3, T> by_lanes(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo, const F& f) {
  using Direction = glm::vec<3, lane_t<T>>;
  glm::vec<3, T> result;
  for (int lane = 0; lane < T::width; ++lane) {
    const Direction i(wi.x[lane], wi.y[lane], wi.z[lane]), o(wo.x[lane], wo.y[lane], wo.z[lane]);
    const Direction value = f(i, o);
    for (int c = 0; c < 3; ++c) result[c].set(lane, value[c]);
  }
  return result;
}

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

/// The half vector of two directions: its squared length before normalisation, |wi + wo|^2, and the squared sine and
/// cosine of its angle to the normal. The sine comes from its own components, not from 1 - cos^2: GGX at a small
/// roughness divides by it. Two opposite directions have none; it is then the normal, of length 0.
template <class T>
struct HalfVector {
  T squared_length, squared_sine, squared_cosine;
};

template <class T>
ZONAL_INLINE inline HalfVector<T> half_vector(const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const glm::vec<3, T> h = wi + wo;
  // no underflow between two grazing directions, and no 0 / 0 between two opposite ones
  const T scale = maximum(maximum(maximum(abs(h.x), abs(h.y)), abs(h.z)), T(1e-37));
  const glm::vec<3, T> s = h * (T(1) / scale);
  const T across = s.x * s.x + s.y * s.y, along = maximum(s.z * s.z, T(1e-30));
  const T inverse = T(1) / (across + along);
  return {scale * scale * (across + along), across * inverse, along * inverse};
}

/// The roughness of a GGX lobe as its kernels take it: within what they give finite values for.
inline float ggx_alpha(float roughness) { return clamp(roughness, 1e-4F, 1.0F); }

/// D of [1] Eq. 33, in 1/sr: alpha^2 / (pi (cos^2 (alpha^2 - 1) + 1)^2), without its cancellation.
template <class T>
ZONAL_INLINE inline T ggx_distribution(const HalfVector<T>& h, T alpha) {
  const T width = h.squared_sine / alpha + alpha * h.squared_cosine;
  return T(1) / (T(kPi) * width * width);
}

/// cos sqrt(1 + alpha^2 tan^2): Smith's Lambda of [2] Eq. 72 is (this / cos - 1) / 2. Finite at the horizon.
template <class T>
ZONAL_INLINE inline T ggx_projected_length(T cos_angle, T alpha) {
  return sqrt(alpha * alpha * (T(1) - cos_angle * cos_angle) + cos_angle * cos_angle);
}

/// G2(wi, wo) / (4 cos_i cos_o) with the height-correlated G2 of [2] Eq. 99; the cosines cancel. The true
/// value diverges when both directions graze; it is held at 5e16, which only cosines below 1e-15 can reach.
template <class T>
ZONAL_INLINE inline T ggx_visibility(T cos_i, T cos_o, T alpha) {
  const T sum = cos_o * ggx_projected_length(cos_i, alpha) + cos_i * ggx_projected_length(cos_o, alpha);
  return T(0.5) / maximum(sum, T(1e-17));
}

/// The real part of (eta + i k)^2 - sin^2, where sin^2 = 1 - c^2. It is c^2 - D of a constant D, and changes its sign
/// at the critical angle, where its square root magnifies every rounding: there it is a product of two factors, the
/// constant in two parts.
template <class T>
ZONAL_INLINE inline T refracted_square(const T& c, float eta, float k) {
  using Wide = std::conditional_t<(sizeof(lane_t<T>) > sizeof(float)), long double, double>;
  const Wide n = Wide(eta), d = (Wide(1) - n) * (Wide(1) + n) + Wide(k) * Wide(k);
  if (d <= Wide(0) || d >= Wide(2)) return c * c - T(d);
  const Wide root = std::sqrt(d);
  const auto high = lane_t<T>(root);
  return ((c - T(high)) - T(root - Wide(high))) * (c + T(high));
}

/// Unpolarised Fresnel reflectance of a half space of index eta + i k, [4] section 1.5.2 carried to a complex
/// index. With a + i b = sqrt((eta + i k)^2 - sin^2), both polarisations are ratios of sums of squares: no
/// cancellation but the physical ones (index 1, Brewster's angle). k = 0 gives a dielectric, total internal
/// reflection included; there a - c = (eta^2 - 1) / (a + c), which is exactly 0 at index 1.
template <class T>
ZONAL_INLINE inline T fresnel_reflectance(const T& cos_angle, float eta, float k) {
  const T c = clamp(cos_angle, T(1e-18), T(1));  // index 1 at grazing incidence would be 0 / 0
  const T squared_sine = (T(1) - c) * (T(1) + c);
  const T real = refracted_square(c, eta, k);
  T a, b2, a_minus_c;
  if (detail::is_equal(k, 0.0F)) {
    a = sqrt(maximum(real, T(0)));
    b2 = maximum(-real, T(0));
    const T eta2_minus_1 = (T(eta) - T(1)) * (T(eta) + T(1));
    a_minus_c = select(real > T(0), eta2_minus_1 / (a + c), -c);
  } else {
    const T product = T(eta) * T(k);  // a b
    const T larger = maximum(T(0.5) * (sqrt(real * real + T(4) * product * product) + abs(real)), T(1e-36));
    const T smaller = product * (product / larger);
    a = sqrt(select(real > T(0), larger, smaller));
    b2 = select(real > T(0), smaller, larger);
    a_minus_c = a - c;
  }
  const auto square = [](const T& x) ZONAL_INLINE { return x * x; };
  const T s_polarised = (square(a_minus_c) + b2) / (square(a + c) + b2);
  const T p_over_s = (square(a * c - squared_sine) + b2 * c * c) / (square(a * c + squared_sine) + b2 * c * c);
  return T(0.5) * s_polarised * (T(1) + p_over_s);
}

}  // namespace detail

/// Fresnel reflectance, RGB in [0, 1], of light that meets a surface at cos_angle in [0, 1].
/// Greatest error in float: 1e-6.
template <class T>
glm::vec<3, T> reflectance(const ConductorFresnel& fresnel, T cos_angle) {
  const glm::vec3 &eta = fresnel.eta, &k = fresnel.k;
  return {detail::fresnel_reflectance(cos_angle, eta.x, k.x), detail::fresnel_reflectance(cos_angle, eta.y, k.y),
          detail::fresnel_reflectance(cos_angle, eta.z, k.z)};
}

template <class T>
glm::vec<3, T> reflectance(const DielectricFresnel& fresnel, T cos_angle) {
  return glm::vec<3, T>(detail::fresnel_reflectance(cos_angle, fresnel.eta, 0.0F));
}

template <class T>
glm::vec<3, T> reflectance(const SchlickFresnel& fresnel, T cos_angle) {
  const glm::vec<3, T> f0(fresnel.f0);
  const T x = T(1) - clamp(cos_angle, T(0), T(1));
  return f0 + (glm::vec<3, T>(T(1)) - f0) * (x * x * x * x * x);
}

template <class T>
glm::vec<3, T> reflectance(const Fresnel& fresnel, T cos_angle) {
  return std::visit([=](const auto& model) { return reflectance(model, cos_angle); }, fresnel);
}

/// The BRDF, RGB in 1/sr. wi, wo: unit vectors in the local frame; zero when either has z <= 0.
template <class T>
glm::vec<3, T> evaluate(const LambertBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  return detail::or_black<T>(detail::above_horizon(wi, wo), glm::vec<3, T>(brdf.albedo) * T(1 / kPi));
}

template <class T>
glm::vec<3, T> evaluate(const PhongBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    if (!detail::above_horizon(wi, wo)) return glm::vec<3, T>(T(0));
    const T exponent = T(brdf.exponent);
    const T normalisation = (exponent + T(2)) / (T(2) * T(kPi));  // [3]
    return glm::vec<3, T>(brdf.specular_albedo) * (normalisation * detail::phong_lobe(wi, wo, exponent));
  } else {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  }
}

/// [1] Eq. 20 with the height-correlated G2 of [2] Eq. 99.
template <class T>
glm::vec<3, T> evaluate(const GgxBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const T alpha = T(detail::ggx_alpha(brdf.roughness));
  const auto h = detail::half_vector(wi, wo);
  const T cos_difference = T(0.5) * sqrt(h.squared_length);  // wi . h = |wi + wo| / 2 for unit vectors
  const glm::vec<3, T> value = reflectance(brdf.fresnel, cos_difference) *
                               (detail::ggx_distribution(h, alpha) * detail::ggx_visibility(wi.z, wo.z, alpha));
  return detail::or_black<T>(detail::above_horizon(wi, wo), value);
}

template <class T>
glm::vec<3, T> evaluate(const MeasuredBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return glm::vec<3, T>((*brdf.function)(glm::dvec3(wi), glm::dvec3(wo)));
  } else {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  }
}

/// The share, RGB in [0, 1], that the other lobe leaves of the light at cos_angle in [0, 1] to the normal.
template <class T>
ZONAL_INLINE inline glm::vec<3, T> left_at(const ResidualBrdf& brdf, const T& cos_angle) {
  const T cosine = clamp(cos_angle, T(0), T(1)), scale = T(brdf.scale);
  const T t2 = T(4) * sqrt((T(1) + scale) * cosine / (scale + cosine)) - T(2);  // 2 t
  const auto term = [&](int k) ZONAL_INLINE { return glm::vec<3, T>(brdf.chebyshev[k]); };
  glm::vec<3, T> next(T(0)), sum = term(ResidualBrdf::degree);  // Clenshaw's
  for (int k = ResidualBrdf::degree - 1; k >= 1; --k) {
    const glm::vec<3, T> before = sum * t2 - next + term(k);
    next = sum;
    sum = before;
  }
  const glm::vec<3, T> left = sum * (T(0.5) * t2) - next + term(0);
  return {clamp(left.x, T(0), T(1)), clamp(left.y, T(0), T(1)), clamp(left.z, T(0), T(1))};
}

template <class T>
glm::vec<3, T> evaluate(const ResidualBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  const glm::vec<3, T> mean(brdf.mean), normalised = glm::vec<3, T>(brdf.albedo) * T(1 / kPi);
  const glm::vec<3, T> both = left_at(brdf, wi.z) * left_at(brdf, wo.z) * normalised;
  // Where next to nothing is left, there is no mean to divide by.
  const T least = T(1e-12);
  const glm::vec<3, T> value(both.x / maximum(mean.x, least), both.y / maximum(mean.y, least),
                             both.z / maximum(mean.z, least));
  return detail::or_black<T>(detail::above_horizon(wi, wo), value);
}

template <class T>
glm::vec<3, T> evaluate(const BrdfLobe& lobe, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  return std::visit([&](const auto& model) { return evaluate(model, wi, wo); }, lobe);
}

template <class T>
glm::vec<3, T> evaluate(const Brdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  glm::vec<3, T> sum(T(0));
  for (const BrdfLobe& lobe : brdf.lobes) sum = sum + evaluate(lobe, wi, wo);
  return sum;
}

/// The sum of a material's Lambert lobes' albedos.
inline glm::vec3 diffuse_albedo(const Brdf& brdf) {
  glm::vec3 sum(0.0F);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (const auto* lambert = std::get_if<LambertBrdf>(&lobe)) sum += lambert->albedo;
  }
  return sum;
}

/// Does the material look the same however it is turned about its normal?
inline bool is_isotropic(const Brdf& brdf) {
  for (const BrdfLobe& lobe : brdf.lobes) {
    const auto* measured = std::get_if<MeasuredBrdf>(&lobe);
    if (measured != nullptr && !measured->isotropic) return false;
  }
  return true;
}

/// A lobe that looks nearly the same from everywhere: Lambert's, and what another lobe leaves.
inline bool is_diffuse(const BrdfLobe& lobe) {
  return std::holds_alternative<LambertBrdf>(lobe) || std::holds_alternative<ResidualBrdf>(lobe);
}

/// The albedo of all lobes of is_diffuse, seen from cos_outgoing in [0, 1].
inline glm::vec3 diffuse_albedo(const Brdf& brdf, float cos_outgoing) {
  glm::vec3 sum = diffuse_albedo(brdf);
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (const auto* body = std::get_if<ResidualBrdf>(&lobe)) sum += body->albedo * left_at(*body, cos_outgoing);
  }
  return sum;
}

/// A material's lobes other than Lambert's.
inline Brdf glossy_part(const Brdf& brdf) {
  Brdf glossy;
  for (const BrdfLobe& lobe : brdf.lobes) {
    if (!std::holds_alternative<LambertBrdf>(lobe)) glossy.lobes.push_back(lobe);
  }
  return glossy;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
