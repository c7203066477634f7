// project, of a cap
#include <zonal/lobe/cap.hpp>

zonal::Zh<BANDS, float> cap(float distance, float radius) {
  return zonal::project<BANDS>(zonal::SphericalCap<float>::from_sphere(distance, radius));
}
