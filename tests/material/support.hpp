// Materials, random directions and plain quadratures for the tests of this room.
#pragma once

#include <zonal/material/energy.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace material_test {

inline constexpr double pi = 3.14159265358979323846;

struct Named {
  std::string name;
  zonal::Brdf brdf;
};

inline zonal::ConductorFresnel gold() { return {{0.14F, 0.37F, 1.44F}, {3.98F, 2.39F, 1.60F}}; }
inline zonal::SchlickFresnel white() { return {glm::vec3(1.0F)}; }

inline zonal::Brdf ggx(float roughness, const zonal::Fresnel& fresnel) {
  return {{zonal::GgxBrdf{roughness, fresnel}}};
}

inline std::vector<Named> materials() {
  std::vector<Named> list{
      {"Lambert", {{zonal::LambertBrdf{{0.7F, 0.5F, 0.2F}}}}},
      {"Phong 0", {{zonal::PhongBrdf{{0.3F, 0.4F, 0.5F}, 0.0F}}}},
      {"Phong 20", {{zonal::PhongBrdf{{0.3F, 0.4F, 0.5F}, 20.0F}}}},
      {"Phong 1000", {{zonal::PhongBrdf{{0.3F, 0.4F, 0.5F}, 1000.0F}}}},
      {"glass 0.3", ggx(0.3F, zonal::DielectricFresnel{1.5F})},
      {"plastic", {{zonal::LambertBrdf{{0.4F, 0.1F, 0.1F}}, zonal::GgxBrdf{0.15F, zonal::DielectricFresnel{1.5F}}}}},
      {"three lobes",
       {{zonal::LambertBrdf{glm::vec3(0.2F)}, zonal::PhongBrdf{glm::vec3(0.3F), 50.0F},
         zonal::GgxBrdf{0.4F, zonal::SchlickFresnel{{0.5F, 0.3F, 0.1F}}}}}},
  };
  for (float roughness : {0.01F, 0.02F, 0.1F, 0.5F, 1.0F}) {
    list.push_back({"gold " + std::to_string(roughness), ggx(roughness, gold())});
  }
  list.push_back({"coated", zonal::coated({0.2F, zonal::DielectricFresnel{1.5F}}, {0.9F, 0.5F, 0.1F})});
  list.push_back({"gold with bounces", zonal::with_multiple_scattering({0.7F, gold()})});
  return list;
}

/// Uniform in [0, 1), the same on every platform.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float operator()() { return float(engine_() >> 8) * 0x1p-24F; }
  /// Uniform on the upper hemisphere.
  glm::vec3 direction() {
    const float z = 1.0F - (*this)(), phi = 2.0F * float(pi) * (*this)(), r = std::sqrt((1.0F - z) * (1.0F + z));
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::mt19937 engine_;
};

template <class T>
glm::vec<3, T> direction(T theta, T phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Outgoing direction at `degrees` from the normal, phi = 0.
inline glm::dvec3 outgoing(double degrees) { return direction(degrees * pi / 180.0, 0.0); }

/// The midpoint rule over the upper hemisphere: sum of visit(wi, solid angle).
template <class Visit>
void midpoint_hemisphere(int theta_count, int phi_count, const Visit& visit) {
  for (int i = 0; i < theta_count; ++i) {
    const double theta = (i + 0.5) * 0.5 * pi / theta_count;
    // the exact solid angle of the cell
    const double weight = 2.0 * std::sin(theta) * std::sin(0.25 * pi / theta_count) * 2.0 * pi / phi_count;
    for (int j = 0; j < phi_count; ++j) visit(direction(theta, (j + 0.5) * 2.0 * pi / phi_count), weight);
  }
}

/// The same integral over the half vector h of wo and wi, whose slope is distributed as that of GGX of this
/// roughness: every cell of the midpoint rule has the same share of D cos, so that no lobe is too sharp.
/// visit(wi, solid angle).
template <class Visit>
void half_vector_hemisphere(double alpha, const glm::dvec3& wo, int slopes, int azimuths, const Visit& visit) {
  for (int i = 0; i < slopes; ++i) {
    const double s = (i + 0.5) / slopes, u = s * s * (3.0 - 2.0 * s), du = 6.0 * s * (1.0 - s) / slopes;
    const double tan2 = alpha * alpha * u / (1.0 - u), cos_h = 1.0 / std::sqrt(1.0 + tan2);
    const double distribution = alpha * alpha / (pi * std::pow(cos_h * cos_h * (alpha * alpha + tan2), 2));
    for (int j = 0; j < azimuths; ++j) {
      const glm::dvec3 h = direction(std::atan(std::sqrt(tan2)), (j + 0.5) * 2.0 * pi / azimuths);
      const double cos_difference = glm::dot(h, wo);
      const glm::dvec3 wi = 2.0 * cos_difference * h - wo;
      if (cos_difference <= 0.0 || wi.z <= 0.0) continue;
      visit(wi, 4.0 * cos_difference * du / (azimuths * distribution * cos_h));
    }
  }
}

/// The integral of f cos over wi: what the material reflects of uniform light.
inline glm::dvec3 ggx_albedo(const zonal::Brdf& brdf, double alpha, const glm::dvec3& wo) {
  glm::dvec3 sum(0.0);
  half_vector_hemisphere(alpha, wo, 300, 300, [&](const glm::dvec3& wi, double solid_angle) {
    sum += evaluate(brdf, wi, wo) * (wi.z * solid_angle);
  });
  return sum;
}

inline double largest(const glm::dvec3& rgb) {
  return std::fmax(std::abs(rgb.x), std::fmax(std::abs(rgb.y), std::abs(rgb.z)));
}

/// The largest component of any coefficient, |a| or |a - b|.
template <class A>
double largest_coefficient(const A& a) {
  double result = 0.0;
  for (const auto& coefficient : a) result = std::fmax(result, largest(glm::dvec3(coefficient)));
  return result;
}
template <class A, class B>
double largest_difference(const A& a, const B& b) {
  double result = 0.0;
  for (int i = 0; i < a.size(); ++i) result = std::fmax(result, largest(glm::dvec3(a[i]) - glm::dvec3(b[i])));
  return result;
}

}  // namespace material_test
