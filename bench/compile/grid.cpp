// interpolate, Hermite
#include <zonal/grid/interpolate.hpp>

zonal::Sh<BANDS, glm::vec3> look_up(const zonal::CoefficientGrid<BANDS>& grid, const glm::vec3& place) {
  return zonal::interpolate<zonal::Interpolation::hermite>(grid, place);
}
