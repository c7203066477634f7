// A light probe out of rays that somebody else chose: 60 of the upper half of the directions, coloured and noisy,
// fitted with and without smoothing. Needs Eigen:
//
//   g++ -std=c++17 -O2 -Iinclude -I/usr/include/eigen3 examples/pages/fit_probe.cpp -o fit_probe && ./fit_probe
#include <zonal/fit/least_squares.hpp>
#include <zonal/transform/dot.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <Eigen/Core>

using Vec3 = std::array<double, 3>;  // or glm::dvec3, Eigen::Vector3d: anything with v[0], v[1], v[2]

int main() {
  std::vector<Vec3> directions;
  std::vector<Eigen::Vector3d> radiance;
  for (int i = 0; i < 60; ++i) {
    const double z = (i + 0.5) / 60, r = std::sqrt(1 - z * z), noise = 0.1 * std::sin(37.0 * i);
    directions.push_back({r * std::cos(2.4 * i), r * std::sin(2.4 * i), z});
    radiance.push_back(Eigen::Vector3d(1 + z, 1, 0.5) + Eigen::Vector3d::Constant(noise));
  }

  const auto span = zonal::direction_span(directions.data(), directions.size());
  std::printf("smoothness  condition  residual of red  above: red, blue  below: red, blue\n");
  for (const double smoothness : {0.0, 1e-3, 1e-1}) {
    const auto fit = zonal::fit_samples<4>(span, radiance.data(), nullptr, smoothness);
    const Eigen::Vector3d above = zonal::reconstruct(fit.sh, Vec3{0, 0, 1}),
                          below = zonal::reconstruct(fit.sh, Vec3{0, 0, -1});
    std::printf("%10g %10.1f %16.3f %11.2f %5.2f %10.2f %5.2f\n", smoothness, fit.condition, fit.residuals[0],
                above.x(), above.z(), below.x(), below.z());
  }
}

// It prints:
//   smoothness  condition  residual of red  above: red, blue  below: red, blue
//            0       79.0            0.069        1.99  0.49      -0.79 -0.29
//        0.001       14.1            0.070        1.98  0.48       0.38  0.42
//          0.1        7.3            0.169        1.76  0.50       1.08  0.49
