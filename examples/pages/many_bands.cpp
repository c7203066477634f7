// A picture's worth of bands, as many as the command line asks for: a lobe of a degree's width, turned, convolved and
// looked up. Needs nothing:
//
//   g++ -std=c++17 -O3 -march=native -Iinclude examples/pages/many_bands.cpp -o many_bands
#include <zonal/many_bands/lobes.hpp>
#include <zonal/many_bands/rotate.hpp>
#include <zonal/many_bands/transform.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int count, char** arguments) try {
  using Vec3 = std::array<double, 3>;  // or anything with v[0], v[1], v[2]
  const int n = count > 1 ? std::atoi(arguments[1]) : 400;
  const zonal::ManyBands<double> bands(n);  // the constants, once; any number of threads may read them

  // A spherical Gaussian about an axis next to the pole, and its value there: 1, but for what no band holds.
  const Vec3 axis{1e-9, 0, 1};
  const zonal::ManyZh<double> lobe = zonal::project(bands, zonal::SphericalGaussian<double>{5000});
  const zonal::ManySh<double> f = zonal::orient(bands, lobe, axis);
  std::printf("%d bands, %d coefficients\n", f.bands(), f.size());
  std::printf("on its axis:          %.9f\n", zonal::reconstruct(bands, f, axis));

  // Rotated it has the same value where its axis has gone.
  const auto rotation = zonal::Rotation<2, double>::from_axis_angle(Vec3{0.6, 0, 0.8}, 2.0);
  double axes[3][3];
  rotation.get_axes(axes);
  Vec3 turned{};
  for (int i = 0; i < 3; ++i) turned[i] = axis[0] * axes[0][i] + axis[1] * axes[1][i] + axis[2] * axes[2][i];
  const zonal::ManySh<double> r = zonal::rotate(f, zonal::ManyRotation<double>(n, rotation));
  std::printf("rotated, on its axis: %.9f\n", zonal::reconstruct(bands, r, turned));

  // Blurred by another Gaussian, and as the E / pi that it sends to a wall.
  const auto blur = zonal::project(bands, zonal::SphericalGaussian<double>{300});
  std::printf("blurred:              %.9f\n", zonal::reconstruct(bands, zonal::convolve(bands, r, blur), turned));
  const auto wall = zonal::project(bands, zonal::LambertLobe{});
  std::printf("E / pi:               %.9f\n", zonal::reconstruct(bands, zonal::convolve(bands, r, wall), turned));
  return 0;
} catch (const std::exception& error) {  // such as: ManyBands: 3000 bands; from 1 to 2000 are possible
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}

// It prints:
//   400 bands, 160000 coefficients
//   on its axis:          0.999999887
//   rotated, on its axis: 0.999999887
//   blurred:              0.001185507
//   E / pi:               0.000399920
