// What the tests of probes share: directions, integrals over the sphere, functions to draw.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <zonal/basis/sh.hpp>
#include <zonal/scalar/quadrature.hpp>

namespace probes {

inline constexpr double pi = 3.14159265358979323846;
using Vec3 = std::array<double, 3>;

inline Vec3 direction(double z, double phi) {
  const double s = std::sqrt((1 - z) * (1 + z));
  return {s * std::cos(phi), s * std::sin(phi), z};
}
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Spread evenly.
inline std::vector<Vec3> spread(int count) {
  std::vector<Vec3> all;
  for (int i = 0; i < count; ++i) all.push_back(direction(1 - (2 * i + 1.0) / count, 2.399963229728653 * i));
  return all;
}

/// The integral over the sphere of a polynomial of degree 30 at most: Gauss' rule in z, even steps in phi.
template <class F>
double integral(const F& f) {
  static const zonal::QuadratureRule rule = zonal::gauss_legendre(16);
  constexpr int steps = 32;
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (int k = 0; k < steps; ++k)
      sum += rule.weights[i] * 2 * pi / steps * f(direction(rule.nodes[i], 2 * pi * (k + 0.5) / steps));
  }
  return sum;
}

/// E / pi at a normal: the same over the half space, with the cosine.
template <class F>
double irradiance_over_pi(const F& radiance, const Vec3& normal) {
  static const zonal::QuadratureRule rule = zonal::gauss_legendre(16);
  constexpr int steps = 32;
  const Vec3 helper = std::abs(normal[2]) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  Vec3 x{helper[1] * normal[2] - helper[2] * normal[1], helper[2] * normal[0] - helper[0] * normal[2],
         helper[0] * normal[1] - helper[1] * normal[0]};
  const double length = std::sqrt(dot(x, x));
  for (double& c : x) c /= length;
  const Vec3 y{normal[1] * x[2] - normal[2] * x[1], normal[2] * x[0] - normal[0] * x[2],
               normal[0] * x[1] - normal[1] * x[0]};
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double c = (rule.nodes[i] + 1) / 2, weight = rule.weights[i] / 2;
    for (int k = 0; k < steps; ++k) {
      const Vec3 d = direction(c, 2 * pi * (k + 0.5) / steps);
      Vec3 w{};
      for (std::size_t j = 0; j < 3; ++j) w[j] = d[0] * x[j] + d[1] * y[j] + d[2] * normal[j];
      sum += weight * 2 * pi / steps * c / pi * radiance(w);
    }
  }
  return sum;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (double(engine_()) + 0.5) * 0x1p-32; }
  double normal() {
    return std::sqrt(-2 * std::log(uniform(0, 1))) * std::cos(uniform(0, 2 * pi));  // the same with every library
  }
  Vec3 direction() {
    const double z = uniform(-1, 1);
    return probes::direction(z, uniform(0, 2 * pi));
  }
  /// A mean of 1 at degree 0, and the others of such a size.
  template <int N>
  zonal::Sh<N, double> function(double size) {
    zonal::Sh<N, double> f{};
    f[0] = 1;
    for (int i = 1; i < N * N; ++i) f[i] = size * normal();
    return f;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace probes
