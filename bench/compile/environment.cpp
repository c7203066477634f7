// project, of a picture
#include <zonal/environment/project.hpp>

zonal::Sh<BANDS, zonal::Rgb<float>> projected(const zonal::Environment<float>& environment) {
  return zonal::project<BANDS>(environment);
}
