// What the projection of a BRDF takes and gives; the projections: projection.hpp, anisotropic_table.hpp.
#pragma once

#include <glm/vec3.hpp>

#include "../basis/sh.hpp"
#include "../scalar/function_ref.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A BRDF in 1/sr, as any function of (wi, wo) that is zero at and below the horizon.
using BrdfFunction = SharedFunction<glm::dvec3(const glm::dvec3&, const glm::dvec3&)>;

/// The coefficients, RGB, dimensionless, for one outgoing direction. `error` is the movement of the last
/// refinement: the greatest over all coefficients of either kind, relative to the largest of that kind; the
/// true error is smaller. `theta_nodes` is the number of nodes it used in each of the two intervals of theta,
/// and in phi.
template <int N>
struct BrdfProjection {
  EvenSh<N, glm::dvec3> with_cosine{}, without_cosine{};
  double error = 0.0;
  int theta_nodes = 0;
};

/// The coefficients, RGB, dimensionless, for one outgoing direction, in its frame; error as in BrdfProjection.
template <int N>
struct AnisotropicProjection {
  Sh<N, glm::dvec3> with_cosine{}, without_cosine{};
  double error = 0.0;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
