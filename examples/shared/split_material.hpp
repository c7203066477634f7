#pragma once

#include <zonal/material/material_table.hpp>

#include "scene.hpp"

namespace example {

/// A material by what its texture colours and what not, each with its table.
struct SplitMaterial {
  zonal::Brdf body, gloss;
  zonal::MaterialTable body_table, gloss_table;

  /// Throws InputError for an anisotropic material.
  explicit SplitMaterial(const Material& material);

  /// The coefficients towards an eye at that cosine, the body in this colour.
  template <int N>
  zonal::EvenSh<N, glm::vec3> row(const glm::vec3& colour, float cos_outgoing) const {
    zonal::EvenSh<N, glm::vec3> row = gloss_table.with_cosine<N>(cos_outgoing);
    const zonal::EvenSh<N, glm::vec3> of_body = body_table.with_cosine<N>(cos_outgoing);
    for (int i = 0; i < row.size(); ++i) row[i] += colour * of_body[i];
    return row;
  }
};

}  // namespace example
