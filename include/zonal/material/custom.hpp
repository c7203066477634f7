// Any model of model.hpp's kind as a lobe of a material, without an edit of the library.
//
// What it does is called through pointers, one direction at a time: packets of directions take it lane by lane.
#pragma once

#include <memory>
#include <utility>

#include "model.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The functions of model.hpp, of one model.
struct LobeFunctions {
  glm::vec3 (*evaluate)(const void*, const glm::vec3& wi, const glm::vec3& wo);
  glm::dvec3 (*evaluate_double)(const void*, const glm::dvec3& wi, const glm::dvec3& wo);
  float (*approximate_albedo)(const void*, const glm::vec3& wo);
  glm::vec3 (*sample)(const void*, const glm::vec3& wo, const glm::vec2& u);
  float (*pdf)(const void*, const glm::vec3& wi, const glm::vec3& wo);
  glm::vec3 (*diffuse_albedo)(const void*, float cos_outgoing);
  glm::vec3 (*glossy_albedo)(const void*, float cos_outgoing);
  GlossyLobe (*glossy_lobe)(const void*, float cos_outgoing);
  glm::vec3 (*glossy_height)(const void*, const glm::vec3& wi, const glm::vec3& wo);
  GlossyGaussian (*glossy_gaussian)(const void*, const glm::vec3& wo);
  glm::vec3 (*gaussian_reflection)(const void*, const glm::vec3& axis, float sharpness, const glm::vec3& wo);
  bool (*is_diffuse)(const void*);
  bool (*is_isotropic)(const void*);
};

template <class M>
const M& model_at(const void* model) {
  return *static_cast<const M*>(model);
}

template <class M>
inline constexpr LobeFunctions lobe_functions{
    [](const void* m, const glm::vec3& wi, const glm::vec3& wo) { return evaluate(model_at<M>(m), wi, wo); },
    [](const void* m, const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(model_at<M>(m), wi, wo); },
    [](const void* m, const glm::vec3& wo) { return approximate_albedo(model_at<M>(m), wo); },
    [](const void* m, const glm::vec3& wo, const glm::vec2& u) { return sample_lobe(model_at<M>(m), wo, u); },
    [](const void* m, const glm::vec3& wi, const glm::vec3& wo) { return lobe_pdf(model_at<M>(m), wi, wo); },
    [](const void* m, float cos_outgoing) { return diffuse_albedo(model_at<M>(m), cos_outgoing); },
    [](const void* m, float cos_outgoing) { return glossy_albedo(model_at<M>(m), cos_outgoing); },
    [](const void* m, float cos_outgoing) { return glossy_lobe(model_at<M>(m), cos_outgoing); },
    [](const void* m, const glm::vec3& wi, const glm::vec3& wo) { return glossy_height(model_at<M>(m), wi, wo); },
    [](const void* m, const glm::vec3& wo) { return glossy_gaussian(model_at<M>(m), wo); },
    [](const void* m, const glm::vec3& axis, float sharpness, const glm::vec3& wo) {
      return gaussian_reflection(model_at<M>(m), axis, sharpness, wo);
    },
    [](const void* m) { return is_diffuse(model_at<M>(m)); },
    [](const void* m) { return is_isotropic(model_at<M>(m)); }};

}  // namespace detail

/// A lobe of a model that the library does not know; custom() makes it. Copies share the model.
struct CustomBrdf {
  std::shared_ptr<const void> model;
  const detail::LobeFunctions* functions;
};

template <class M>
CustomBrdf custom(M model) {
  return {std::make_shared<const M>(std::move(model)), &detail::lobe_functions<M>};
}

template <class T>
glm::vec<3, T> evaluate(const CustomBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if constexpr (!is_builtin_scalar_v<T>) {
    return detail::by_lanes(wi, wo, [&](const auto& i, const auto& o) { return evaluate(brdf, i, o); });
  } else if constexpr (sizeof(T) == sizeof(float)) {
    return brdf.functions->evaluate(brdf.model.get(), wi, wo);
  } else {
    return glm::vec<3, T>(brdf.functions->evaluate_double(brdf.model.get(), glm::dvec3(wi), glm::dvec3(wo)));
  }
}

inline float approximate_albedo(const CustomBrdf& brdf, const glm::vec3& wo) {
  return brdf.functions->approximate_albedo(brdf.model.get(), wo);
}
inline glm::vec3 sample_lobe(const CustomBrdf& brdf, const glm::vec3& wo, const glm::vec2& u) {
  return brdf.functions->sample(brdf.model.get(), wo, u);
}
template <class T>
T lobe_pdf(const CustomBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return T(brdf.functions->pdf(brdf.model.get(), glm::vec3(wi), wo));
  } else {
    const auto pdf = [&](const auto& i, const auto& o) { return glm::vec<3, lane_t<T>>(lobe_pdf(brdf, i, o)); };
    return detail::by_lanes(wi, glm::vec<3, T>(wo), pdf).x;
  }
}
inline glm::vec3 diffuse_albedo(const CustomBrdf& brdf, float cos_outgoing) {
  return brdf.functions->diffuse_albedo(brdf.model.get(), cos_outgoing);
}
inline glm::vec3 glossy_albedo(const CustomBrdf& brdf, float cos_outgoing) {
  return brdf.functions->glossy_albedo(brdf.model.get(), cos_outgoing);
}
inline GlossyLobe glossy_lobe(const CustomBrdf& brdf, float cos_outgoing) {
  return brdf.functions->glossy_lobe(brdf.model.get(), cos_outgoing);
}
template <class T>
glm::vec<3, T> glossy_height(const CustomBrdf& brdf, const glm::vec<3, T>& wi, const glm::vec3& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return glm::vec<3, T>(brdf.functions->glossy_height(brdf.model.get(), glm::vec3(wi), wo));
  } else {
    const auto height = [&](const auto& i, const auto&) { return glossy_height(brdf, i, wo); };
    return detail::by_lanes(wi, wi, height);
  }
}
inline GlossyGaussian glossy_gaussian(const CustomBrdf& brdf, const glm::vec3& wo) {
  return brdf.functions->glossy_gaussian(brdf.model.get(), wo);
}
template <class T>
glm::vec<3, T> gaussian_reflection(const CustomBrdf& brdf, const glm::vec<3, T>& axis, const T& sharpness,
                                   const glm::vec3& wo) {
  if constexpr (is_builtin_scalar_v<T>) {
    return glm::vec<3, T>(brdf.functions->gaussian_reflection(brdf.model.get(), glm::vec3(axis), float(sharpness), wo));
  } else {
    const auto reflection = [&](const auto& lane_axis, const auto& lane_sharpness) {
      return gaussian_reflection(brdf, lane_axis, lane_sharpness.x, wo);
    };
    return detail::by_lanes(axis, glm::vec<3, T>(sharpness), reflection);
  }
}
inline bool is_diffuse(const CustomBrdf& brdf) { return brdf.functions->is_diffuse(brdf.model.get()); }
inline bool is_isotropic(const CustomBrdf& brdf) { return brdf.functions->is_isotropic(brdf.model.get()); }

}  // namespace ZONAL_TARGET
}  // namespace zonal
