#pragma once

#include <cstdint>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <zonal/environment/mapping.hpp>

#include "shared/image.hpp"
#include "shared/incident_radiance.hpp"

namespace example::field_capture {

/// What all probes of a sequence have in common.
struct ProbeCamera {
  zonal::Mapping mapping = zonal::Mapping::mirror_sphere;
  int width = 128, height = 128;  // texels
  double sphere_radius = 0.0;     // metres; of a mirror sphere
  double dead_angle = 0.0;        // radians; the same

  /// That high, and as wide as the mapping asks for; faces of cubes have half as many texels a side.
  static ProbeCamera of_side(zonal::Mapping mapping, int side);
};

/// From a picture's axes, x forward, y left, z up, to a scene's, y up, looked at along -z.
glm::quat picture_orientation();

/// The picture of a probe: of surfaces and rectangles the mean along `samples` rays in each texel; of discs, smaller
/// than texels, what many of their points send, in the texel that shows them, over its solid angle. Texels of no
/// direction are black. The same for any number of threads; not all done where a stop is requested.
Image capture_probe(const ProbeCamera& camera, const IncidentRadiance& light, const glm::vec3& position, int samples,
                    std::uint64_t seed);

}  // namespace example::field_capture
