// The std-only face: the irradiance at a point below a sphere light.
#include <array>
#include <cmath>
#include <cstdio>
#include <zonal/version.hpp>
#include <zonal/zonal.hpp>

int main() {
  const std::array<float, 3> up{0.0f, 0.0f, 1.0f};
  const auto cap = zonal::SphericalCap<float>::from_sphere(2.0f, 1.0f);
  const zonal::Zh<3, float> zh = zonal::project<3>(cap);
  const zonal::Sh<3, float> light = zonal::orient(zh, up);
  const zonal::Sh<3, float> basis = zonal::evaluate<3>(up);

  // The mean of a cap's indicator is its share of the sphere: (1 - cos a) / 2 = Y_0 z_0, sin a = 1/2.
  const float share = zonal::get<0, 0>(light) * zonal::get<0, 0>(basis);
  const float expected = (1.0f - std::sqrt(0.75f)) / 2.0f;
  const float value = zonal::dot(light, basis);
  std::printf("zonal %d.%d.%d: share %g, expected %g, value at the axis %g\n", zonal::version_major,
              zonal::version_minor, zonal::version_patch, static_cast<double>(share), static_cast<double>(expected),
              static_cast<double>(value));
  return std::fabs(share - expected) < 1e-6f && value > 0.0f ? 0 : 1;
}
