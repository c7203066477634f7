// project_with_gradient, of a sphere light
#include <zonal/light/sphere.hpp>

zonal::ShGradient<BANDS, float> light(const zonal::SphereLight<float>& sphere, const glm::vec3& place) {
  return zonal::project_with_gradient<BANDS>(sphere, place);
}
