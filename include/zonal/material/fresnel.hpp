// What a smooth interface reflects.
//
// [1] M. Born, E. Wolf, "Principles of Optics", 7th edition, 1999, sections 1.5.2 and 14.2.
// [2] C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", CGF 13(3), 1994.
#pragma once

#include <cmath>
#include <type_traits>
#include <variant>

#include <glm/vec3.hpp>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

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

/// Schlick's approximation [2]. f0: RGB reflectance at normal incidence, in [0, 1].
struct SchlickFresnel {
  glm::vec3 f0;
};

using Fresnel = std::variant<ConductorFresnel, DielectricFresnel, SchlickFresnel>;

namespace detail {

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

/// Unpolarised Fresnel reflectance of a half space of index eta + i k, [1] section 1.5.2 carried to a complex
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

}  // namespace ZONAL_TARGET
}  // namespace zonal
