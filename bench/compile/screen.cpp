// incident_radiance
#include <zonal/screen/incident.hpp>

zonal::Sh<BANDS, glm::vec3> arriving(const zonal::LightSet& lights, const glm::vec3& position,
                                     const glm::vec3& normal) {
  return zonal::incident_radiance<BANDS>(lights, position, normal, 0.01F);
}
