// What a material's model is: one struct in one file, and the functions beside it.
//
// Directions are unit vectors in the local frame, z being the surface normal; wi points towards the light, wo
// towards the eye. A model M is any copyable struct, in any namespace, with
//
//   template <class T> glm::vec<3, T> evaluate(const M&, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo);
//
// found beside it (by argument-dependent look-up): the BRDF in 1/sr, one value per RGB channel, reciprocal (measured
// materials may not be), exactly zero when either direction is at or below the horizon, for T float and double. That is
// enough: custom(model), in custom.hpp, is then a lobe like any other, for projections, paths and virtual lights.
//
// The others below are defaults. A model that has better writes the same function beside itself.
//
//   approximate_albedo(m, wo)    what lobes are chosen by         1
//   sample_lobe, lobe_pdf        directions, and their density    by the cosine
//   diffuse_albedo(m, cos)       of the part that looks alike     a mean over 64
//                                from everywhere, for VSGL        directions
//   glossy_albedo, glossy_lobe,  of the part about the mirror     none
//   glossy_height                direction, for VSGL
//   glossy_gaussian,             of the same part, for VSGL by    none
//   gaussian_reflection          the formulas of 2024
//   is_diffuse(m)                is there nothing but the former? no
//   is_isotropic(m)              is f a function of the difference of azimuths alone, and even in it? yes
//
// To add a material, in three steps:
//
// 1. Write the struct and its evaluate() in a file of its own; oren_nayar.hpp is a sample. Where the default, the
//    cosine, would sample it badly, write approximate_albedo(), sample_lobe() and lobe_pdf().
// 2. Add it to the lists of tests/material/models_test.cpp and sampling_test.cpp: reciprocity, furnace, and directions
//    that come as their density says.
// 3. Brdf{{custom(MyModel{...}), ...}} is the material.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

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

inline float mean(const glm::vec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3.0F; }

}  // namespace detail

/// A glossy lobe as an anisotropic spherical Gaussian about the mirror direction: its bandwidths in the plane of
/// incidence and across it. Both 0: there is none.
struct GlossyLobe {
  float in_plane, across;
  /// That of the circularly symmetric Gaussian of the same integral.
  float sharpness() const { return 2.0F * std::sqrt(in_plane * across); }
};

/// A glossy lobe as a spherical Gaussian exp(sharpness (cos - 1)) about the axis.
struct GlossyGaussian {
  glm::vec3 axis;  // unit
  float sharpness;
};

// ---- Defaults -------------------------------------------------------------------------------------------------------

/// About the albedo seen from wo, channels averaged. It is positive wherever the lobe is, which is all that correctness
/// asks for.
template <class M>
float approximate_albedo(const M&, const glm::vec3&) {
  return 1.0F;
}

/// A direction towards the light; u in [0, 1)^2. It may lie below the horizon, and is then no sample.
template <class M>
glm::vec3 sample_lobe(const M&, const glm::vec3&, const glm::vec2& u) {
  const float radius = std::sqrt(u.x), phi = 2.0F * float(kPi) * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0F - u.x)};
}

/// Its density in 1/sr, of wi above the horizon; T is float, or a packet.
template <class M, class T>
ZONAL_INLINE inline T lobe_pdf(const M&, const glm::vec<3, T>& wi, const glm::vec3&) {
  return wi.z * T(1 / kPi);
}

/// RGB, seen at that cosine to the normal, in (0, 1]. The default is a mean over 64 directions, right for broad models,
/// and slow.
template <class M>
glm::vec3 diffuse_albedo(const M& model, float cos_outgoing) {
  constexpr int rings = 8, spokes = 8;
  const float cosine = clamp(cos_outgoing, 0.0F, 1.0F);  // rounding may have left it outside
  const glm::vec3 wo(std::sqrt((1.0F - cosine) * (1.0F + cosine)), 0.0F, cosine);
  glm::vec3 sum(0.0F);
  for (int i = 0; i < rings; ++i) {
    const float squared_sine = (float(i) + 0.5F) / rings, sine = std::sqrt(squared_sine);
    for (int j = 0; j < spokes; ++j) {
      const float phi = 2.0F * float(kPi) * (float(j) + 0.5F) / spokes;
      sum += evaluate(model, glm::vec3(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1.0F - squared_sine)), wo);
    }
  }
  return sum * (float(kPi) / float(rings * spokes));
}
template <class M>
glm::vec3 glossy_albedo(const M&, float) {
  return glm::vec3(0.0F);
}
template <class M>
GlossyLobe glossy_lobe(const M&, float) {
  return {0.0F, 0.0F};
}

/// The height of the glossy Gaussian, cosine included, RGB, where the light comes from wi.
template <class M, class T>
ZONAL_INLINE inline glm::vec<3, T> glossy_height(const M&, const glm::vec<3, T>&, const glm::vec3&) {
  return glm::vec<3, T>(T(0));
}

/// The Gaussian that the glossy part is about, seen from wo.
template <class M>
GlossyGaussian glossy_gaussian(const M&, const glm::vec3&) {
  return {{0.0F, 0.0F, 1.0F}, 0.0F};
}

/// What the glossy part reflects towards wo, RGB, of light exp(sharpness (cos - 1)) about `axis`: the integral of f cos
/// times it. wo has y = 0 and z > 0; T is float, double, or a packet.
template <class M, class T>
ZONAL_INLINE inline glm::vec<3, T> gaussian_reflection(const M&, const glm::vec<3, T>&, const T&, const glm::vec3&) {
  return glm::vec<3, T>(T(0));
}

template <class M>
bool is_diffuse(const M&) {
  return false;
}
template <class M>
bool is_isotropic(const M&) {
  return true;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
