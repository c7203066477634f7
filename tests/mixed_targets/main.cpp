// Lights kept by one translation unit and gathered by another must give what they give within one.
#include <cmath>
#include <cstdio>

#include "scene.hpp"

int main() {
  const zonal::MaterialTable table = white();
  const zonal::Receiver receiver{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  Scene own, other;
  build_here(own);
  build(other);
  const float expected = zonal::gather<3>(own.cache, receiver, table).x;
  const float got = zonal::gather<3>(other.cache, receiver, table).x;
  std::printf("%.6f, expected %.6f\n", double(got), double(expected));
  return expected > 0 && std::abs(got - expected) <= 1e-6F * expected ? 0 : 1;
}
