#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <zonal/basis/sh.hpp>

#include "shared/incident_radiance.hpp"
#include "shared/progress.hpp"

namespace example::field_capture {

inline constexpr int most_truth_bands = 9;
using Truth = zonal::Sh<most_truth_bands, glm::dvec3>;

/// The coefficients of what arrives at a place, in the scene's axes: of surfaces by so many paths, of each emitter by
/// thousands of its points. The same for any number of threads. Throws Interrupted soon after Ctrl-C.
Truth true_coefficients(const IncidentRadiance& light, const glm::vec3& place, int paths, std::uint64_t seed);

/// A line for each place: its position, and `bands` bands of its coefficients, RGB innermost.
std::string truth_csv(const IncidentRadiance& light, const std::vector<glm::vec3>& places, int bands, int paths,
                      std::uint64_t seed, bool quiet);

}  // namespace example::field_capture
