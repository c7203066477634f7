// A perfectly diffuse surface: the defaults of model.hpp are its own.
#pragma once

#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Perfectly diffuse reflection, f = albedo / pi. albedo: RGB in [0, 1].
struct LambertBrdf {
  glm::vec3 albedo;
};

/// The BRDF, RGB in 1/sr. wi, wo: unit vectors in the local frame; zero when either has z <= 0.
template <class T>
glm::vec<3, T> evaluate(const LambertBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  return detail::or_black<T>(detail::above_horizon(wi, wo), glm::vec<3, T>(brdf.albedo) * T(1 / kPi));
}

inline float approximate_albedo(const LambertBrdf& brdf, const glm::vec3&) { return detail::mean(brdf.albedo); }
inline glm::vec3 diffuse_albedo(const LambertBrdf& brdf, float) { return brdf.albedo; }
inline bool is_diffuse(const LambertBrdf&) { return true; }

}  // namespace ZONAL_TARGET
}  // namespace zonal
