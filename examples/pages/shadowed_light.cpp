// Light times visibility: a lamp behind a ball, and beside a wall, by products of coefficients. Standard library alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/shadowed_light.cpp -o shadowed_light && ./shadowed_light
#include <zonal/zonal.hpp>

#include <array>
#include <cmath>
#include <cstdio>

using Vec3 = std::array<double, 3>;  // or glm::vec3, Eigen::Vector3f: anything with v[0], v[1], v[2]
using Cap = zonal::SphericalCap<double>;

// The lamp covers a cap of directions, and so does the ball. A wall covers half of all directions, a cap as well.
const Vec3 up{0, 0, 1}, to_lamp{0.6, 0, 0.8}, to_ball{0.28, 0, 0.96}, behind_wall{0.8, 0, -0.6};
const double lamp_angle = 0.4, ball_angle = 0.3, wall_angle = std::acos(-1.0) / 2;

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// 1 where nothing stands, 0 where the cap does.
template <int N>
zonal::Sh<N, double> visibility(double half_angle, const Vec3& axis) {
  zonal::Sh<N, double> visible = -zonal::orient(zonal::project<N>(Cap::from_angle(half_angle)), axis);
  visible(0, 0) += 2 * std::sqrt(std::acos(-1.0));  // the coefficient of 1
  return visible;
}

// E / pi at a surface that faces up: radiance 1, what is in the way, and the clamped cosine.
template <int N>
void print() {
  const auto lamp = zonal::orient(zonal::project<N>(Cap::from_angle(lamp_angle)), to_lamp);
  const auto lambert = zonal::project<N, double>(zonal::LambertLobe{});
  const auto open = zonal::reconstruct_convolved(lamp, lambert, up);
  // For one normal: the integral of three functions.
  const auto ball = zonal::triple_product(lamp, visibility<N>(ball_angle, to_ball), zonal::orient(lambert, up));
  // For many normals: what is seen of the lamp, as coefficients.
  const zonal::Sh<N, double> seen = zonal::product(lamp, visibility<N>(wall_angle, behind_wall));
  std::printf("%2d bands  %.4f  %.4f  %.4f\n", N, open, ball, zonal::reconstruct_convolved(seen, lambert, up));
}

// The same by adding up directions.
template <class IsSeen>
double exact(IsSeen is_seen) {
  const int steps = 2000;
  const double pi = std::acos(-1.0);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double z = (i + 0.5) / steps, r = std::sqrt(1 - z * z);
    for (int j = 0; j < steps; ++j) {
      const double phi = 2 * pi * (j + 0.5) / steps;
      const Vec3 d{r * std::cos(phi), r * std::sin(phi), z};
      if (dot(d, to_lamp) > std::cos(lamp_angle) && is_seen(d)) sum += z / pi;
    }
  }
  return sum * 2 * pi / (double(steps) * steps);
}

int main() {
  std::printf("          lamp    ball    wall\n");
  print<3>(), print<5>(), print<9>(), print<13>();
  std::printf("exactly   %.4f  %.4f  %.4f\n", exact([](const Vec3&) { return true; }),
              exact([](const Vec3& d) { return dot(d, to_ball) < std::cos(ball_angle); }),
              exact([](const Vec3& d) { return dot(d, behind_wall) < std::cos(wall_angle); }));
}

// It prints:
//             lamp    ball    wall
//    3 bands  0.1202  0.1031  0.0717
//    5 bands  0.1224  0.0869  0.0665
//    9 bands  0.1213  0.0803  0.0682
//   13 bands  0.1213  0.0798  0.0687
//   exactly   0.1213  0.0805  0.0686
