// The face that needs GLM and Eigen.
#include <glm/glm.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/zonal.hpp>

int main() {
  const auto sh = zonal::evaluate<3>(glm::vec3(0.0f, 0.6f, 0.8f));
  return zonal::dot(sh, sh) > 0.0f ? 0 : 1;
}
