// A ball in the light of a spherical lamp, by nine numbers: writes lit_sphere.ppm. Standard library alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/lit_sphere.cpp -o lit_sphere && ./lit_sphere
#include <zonal/zonal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

using Vec3 = std::array<float, 3>;  // or glm::vec3, Eigen::Vector3f: anything with v[0], v[1], v[2]

int main() {
  // A lamp of radius 1 and radiance 4, three units from the ball, as a cap of the sphere of directions: three bands.
  // The ball's own extent is left out: all of it receives what its centre would.
  const Vec3 to_lamp{0.48F, 0.6F, 0.64F};
  const auto cap = zonal::SphericalCap<float>::from_sphere(3.0F, 1.0F);
  const zonal::Sh<3, float> radiance = zonal::orient(zonal::project<3>(cap) * 4.0F, to_lamp);

  // Convolved with the clamped cosine over pi: what a white matt surface of any normal sends out, E / pi.
  const auto reflected = zonal::convolve(radiance, zonal::project<3, float>(zonal::LambertLobe{}));

  const int size = 256;
  std::ofstream picture("lit_sphere.ppm", std::ios::binary);
  picture << "P6 " << size << ' ' << size << " 255\n";
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const float x = (float(column) + 0.5F) / (0.5F * size) - 1.0F, y = 1.0F - (float(row) + 0.5F) / (0.5F * size);
      const float z2 = 1.0F - x * x - y * y;  // x to the right, y up, z towards us
      const float value = z2 < 0.0F ? 0.0F : zonal::reconstruct(reflected, Vec3{x, y, std::sqrt(z2)});
      const float shown = 255.0F * std::pow(std::clamp(value, 0.0F, 1.0F), 1.0F / 2.2F);
      for (const float tint : {1.0F, 0.9F, 0.75F}) picture.put(char(int(tint * shown)));
    }
  }

  // A lamp that stands above the horizon in full gives radiance * sin^2(half angle) * cosine.
  std::printf("towards the lamp: %.3f of three bands, exactly %.3f\n", double(zonal::reconstruct(reflected, to_lamp)),
              4.0 / 9.0);
  return picture.flush() ? 0 : 1;
}

// It prints:
//   towards the lamp: 0.468 of three bands, exactly 0.444
