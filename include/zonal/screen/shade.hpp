// What a surface makes of incident radiance that the filter has averaged: any normal and any material, after the
// filter.
//
// Lambert's reflection is reconstruct_convolved(radiance, LambertLobe{}, normal), times the albedo; Phong's
// reconstruct_convolved(radiance, project<N>(PhongLobe{n}), mirror direction) (transform/convolve.hpp, [1] 3.3). Other
// materials come from their table: its row at the outgoing direction stands in the frame of the normal, where the eye
// has phi = 0, and there the radiance is turned.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../gather/receiver.hpp"
#include "../material/material_rows.hpp"
#include "../transform/rotate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The direction that a mirror sends the eye's ray to: about it the lobes of Phong's kind stand.
inline glm::vec3 mirror_direction(const glm::vec3& normal, const glm::vec3& outgoing) {
  return 2 * glm::dot(normal, outgoing) * normal - outgoing;
}

/// The radiance turned to the frame of the normal in which `outgoing` has phi = 0. Both unit.
template <int N>
Sh<N, glm::vec3> in_shading_frame(const Sh<N, glm::vec3>& radiance, const glm::vec3& normal,
                                  const glm::vec3& outgoing) {
  if constexpr (N == 1) {
    return radiance;
  } else {
    const glm::vec3 tangent = detail::tangent_towards(normal, outgoing), bitangent = glm::cross(normal, tangent);
    // Where the world's axes go.
    const auto axis = [&](int i) { return glm::vec3(tangent[i], bitangent[i], normal[i]); };
    return rotate(radiance, Rotation<N, float>::from_axes(axis(0), axis(1), axis(2)));
  }
}

/// Reflected radiance: the integral of the incident radiance times the material, F of MaterialTable::with_cosine at the
/// outgoing direction, both in the frame of in_shading_frame. Of N bands light may come out negative, and is cut at 0.
template <int N>
glm::vec3 reflected_radiance(const Sh<N, glm::vec3>& in_frame, const EvenSh<N, glm::vec3>& material) {
  glm::vec3 sum(0);
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) sum += in_frame(l, m) * material(l, m);
  }
  return (glm::max)(sum, glm::vec3(0));
}

/// The same of radiance in the world's axes and a material's table.
template <int N>
glm::vec3 reflected_radiance(const Sh<N, glm::vec3>& radiance, const MaterialTable& material, const glm::vec3& normal,
                             const glm::vec3& outgoing) {
  return reflected_radiance(in_shading_frame(radiance, normal, outgoing),
                            material.template with_cosine<N>(glm::dot(normal, outgoing)));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
