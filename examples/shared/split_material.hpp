#pragma once

#include <zonal/material/material_table.hpp>
#include <zonal/transform/window.hpp>

#include "materials.hpp"
#include "scene.hpp"

namespace example {

/// A material's parts, each with its table.
struct SplitMaterial : BodyAndRest {
  zonal::MaterialTable body_table, rest_table;

  /// Throws InputError for an anisotropic material.
  explicit SplitMaterial(const Material& material);

  /// The coefficients towards an eye at that cosine, the body in a texture's colour. The window is for the rest alone:
  /// what is matte does not ring, and would be blurred.
  template <int N>
  zonal::EvenSh<N, glm::vec3> row(const glm::vec3& colour, float cos_outgoing, zonal::Window window) const {
    zonal::EvenSh<N, glm::vec3> row = zonal::apply_window(rest_table.with_cosine<N>(cos_outgoing), window);
    const zonal::EvenSh<N, glm::vec3> of_body = body_table.with_cosine<N>(cos_outgoing);
    for (int i = 0; i < row.size(); ++i) row[i] += colour * of_body[i];
    return row;
  }
};

}  // namespace example
