// Every kernel of the library in one shape: from an array of inputs to a list of outputs, in any scalar.
#pragma once

#include <zonal/gather/hvl.hpp>
#include <zonal/light/point.hpp>
#include <zonal/light/triangle.hpp>
#include <zonal/zonal.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace kernels {

/// Inputs of a kernel, in double.
class Sampler {
 public:
  explicit Sampler(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  /// A unit vector; one in four lies near a pole.
  std::array<double, 3> direction() {
    const double width = uniform(0, 1) < 0.25 ? 1e-3 : 1;
    std::normal_distribution<double> normal;
    const double x = width * normal(random_), y = width * normal(random_), z = normal(random_);
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
  }
  /// Cosine and sine of an angle from 0 to `greatest`.
  std::array<double, 2> angle(double greatest) {
    const double a = uniform(1e-3, greatest);
    return {std::cos(a), std::sin(a)};
  }

 private:
  std::mt19937 random_;
};

template <class Array>
std::vector<double> list(const Array& values) {
  return {values.begin(), values.end()};
}

// Each kernel has a name; its greatest error, in ulps of its largest output; inputs of its domain; and itself.

struct Evaluate {
  static constexpr const char* name = "evaluate";
  static constexpr double ulps = 20;
  static std::vector<double> sample(Sampler& s) { return list(s.direction()); }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::evaluate<6>(in[0], in[1], in[2], [&](auto, auto, const T& y) { out.push_back(y); });
  }
};

struct EvaluateEven {
  static constexpr const char* name = "evaluate_even";
  static constexpr double ulps = 20;
  static std::vector<double> sample(Sampler& s) {
    const auto v = s.direction();
    return {v[0], v[2]};
  }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::evaluate_even<6>(in[0], in[1], [&](auto, auto, const T& y) { out.push_back(y); });
  }
};

struct EvaluateZonal {
  static constexpr const char* name = "evaluate_zonal";
  static constexpr double ulps = 20;
  static std::vector<double> sample(Sampler& s) { return {s.uniform(-1, 1)}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::evaluate_zonal<6>(in[0], [&](auto, const T& y) { out.push_back(y); });
  }
};

struct EvaluateWithGradient {
  static constexpr const char* name = "evaluate_with_gradient";
  static constexpr double ulps = 40;
  static std::vector<double> sample(Sampler& s) { return list(s.direction()); }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::evaluate_with_gradient<5>(in[0], in[1], in[2],
                                     [&](auto, auto, const T& y, const T& gx, const T& gy, const T& gz) {
                                       out.insert(out.end(), {y, gx, gy, gz});
                                     });
  }
};

struct Cap {
  static constexpr const char* name = "project(SphericalCap)";
  static constexpr double ulps = 8;
  static std::vector<double> sample(Sampler& s) { return list(s.angle(3.1)); }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project<6>(zonal::SphericalCap<T>{in[0], in[1]}, [&](auto, const T& z) { out.push_back(z); });
  }
};

struct SphereCap {
  static constexpr const char* name = "project(SphericalCap::from_sphere)";
  static constexpr double ulps = 8;
  static std::vector<double> sample(Sampler& s) { return {s.uniform(1.5, 20), s.uniform(0.01, 1.4)}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project<6>(zonal::SphericalCap<T>::from_sphere(in[0], in[1]), [&](auto, const T& z) { out.push_back(z); });
  }
};

struct CapDerivative {
  static constexpr const char* name = "project_derivative(SphericalCap)";
  static constexpr double ulps = 16;
  static std::vector<double> sample(Sampler& s) { return list(s.angle(3.1)); }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project_derivative<6>(zonal::SphericalCap<T>{in[0], in[1]}, [&](auto, const T& z) { out.push_back(z); });
  }
};

struct Lambert {
  static constexpr const char* name = "project(LambertLobe)";
  static constexpr double ulps = 1;
  static std::vector<double> sample(Sampler&) { return {}; }
  template <class T>
  static void run(const std::vector<T>&, std::vector<T>& out) {
    zonal::project<6, T>(zonal::LambertLobe{}, [&](auto, const T& z) { out.push_back(z); });
  }
};

struct Phong {
  static constexpr const char* name = "project(PhongLobe)";
  static constexpr double ulps = 8;
  static std::vector<double> sample(Sampler& s) { return {std::exp(s.uniform(-3, 7))}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project<6>(zonal::PhongLobe<T>{in[0]}, [&](auto, const T& z) { out.push_back(z); });
  }
};

struct Gaussian {
  static constexpr const char* name = "project(SphericalGaussian)";
  static constexpr double ulps = 16;
  static std::vector<double> sample(Sampler& s) { return {std::exp(s.uniform(-5, 7))}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project<6>(zonal::SphericalGaussian<T>{in[0]}, [&](auto, const T& z) { out.push_back(z); });
  }
};

struct Orient {
  static constexpr const char* name = "orient";
  static constexpr double ulps = 20;
  static std::vector<double> sample(Sampler& s) {
    std::vector<double> in = list(s.direction());
    for (int l = 0; l < 5; ++l) in.push_back(s.uniform(-1, 1));
    return in;
  }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::Zh<5, T> zh{};
    for (int l = 0; l < 5; ++l) zh[l] = in[static_cast<std::size_t>(3 + l)];
    zonal::orient(zh, in[0], in[1], in[2], [&](auto, auto, const T& y) { out.push_back(y); });
  }
};

struct ConvolveAndDot {
  static constexpr const char* name = "convolve, dot, reconstruct";
  static constexpr double ulps = 30;
  static std::vector<double> sample(Sampler& s) {
    std::vector<double> in = list(s.direction());
    for (int i = 0; i < 20; ++i) in.push_back(s.uniform(-1, 1));
    return in;
  }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::Sh<4, T> sh{};
    zonal::Zh<4, T> zh{};
    for (int i = 0; i < 16; ++i) sh[i] = in[static_cast<std::size_t>(3 + i)];
    for (int l = 0; l < 4; ++l) zh[l] = in[static_cast<std::size_t>(19 + l)];
    const auto blurred = zonal::convolve(sh, zh);
    out.insert(out.end(), blurred.begin(), blurred.end());
    out.push_back(zonal::dot(sh, blurred));
    out.push_back(zonal::dot(zh, zonal::convolve(zh, zh)));
    out.push_back(zonal::reconstruct(blurred, std::array<T, 3>{in[0], in[1], in[2]}));
    out.push_back(zonal::reconstruct_zonal(zh, in[2]));
  }
};

struct Arcs {
  static constexpr const char* name = "asin, acos, angle_from";
  static constexpr double ulps = 8;
  static std::vector<double> sample(Sampler& s) { return list(s.angle(3.1)); }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    out.push_back(zonal::asin(in[0]));
    out.push_back(zonal::acos(in[0]));
    out.push_back(zonal::angle_from(in[0], in[1]));
    out.push_back(zonal::sin_cos(in[0]).sine);
    out.push_back(zonal::sin_cos(in[0]).cosine);
  }
};

template <zonal::Horizon method>
struct HorizonOf {
  static constexpr const char* name = method == zonal::Horizon::exact ? "horizon_exact" : "horizon_smoothstep";
  static constexpr double ulps = 200;
  static std::vector<double> sample(Sampler& s) {
    const auto cap = s.angle(1.5);
    return {cap[0], cap[1], cap[1] * s.uniform(-0.98, 0.98)};
  }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    out.push_back(zonal::horizon<method>(zonal::SphericalCap<T>{in[0], in[1]}, in[2]));
  }
};

/// Value and gradient of a light, by where the receiver stands.
template <class Light>
struct ProjectWithGradient {
  static constexpr double ulps = Light::ulps;
  static constexpr const char* name = Light::name;
  static std::vector<double> sample(Sampler& s) { return {s.uniform(-1, 1), s.uniform(-1, 1), s.uniform(-1, 1)}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    zonal::project_with_gradient<4>(Light::light(), in[0], in[1], in[2],
                                    [&](auto, auto, const T& y, const T& gx, const T& gy, const T& gz) {
                                      out.insert(out.end(), {y, gx, gy, gz});
                                    });
  }
};
struct Sphere {
  static constexpr const char* name = "SphereLight with gradient";
  static constexpr double ulps = 60;
  static zonal::SphereLight<double> light() { return {{0.5, -0.25, 3}, 0.5}; }
};
struct Spot {
  static constexpr const char* name = "SpotLight with gradient";
  static constexpr double ulps = 100;
  static zonal::SpotLight<double> light() { return {{0.5, -0.25, 3}, {0, 0, -1}, 0.96875, 0.25}; }
};
struct TriangleSphere {
  static constexpr const char* name = "TriangleSphereLight with gradient";
  static constexpr double ulps = 100;
  static zonal::TriangleSphereLight<double> light() { return {{0.5, -0.25, 3}, {0, 0.6, 0.8}, 0.5}; }
};

struct Polygon {
  static constexpr const char* name = "PolygonLight with gradient";
  static constexpr double ulps = 400;
  static std::vector<double> sample(Sampler& s) { return {s.uniform(-1, 1), s.uniform(-1, 1), s.uniform(-1, 1)}; }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    static const zonal::QuadratureRule rule = zonal::gauss_legendre(3);
    const zonal::TriangleLight<double> light{{{-1, -1, 2}, {1, -0.5, 2.5}, {0.25, 1, 2}}};
    zonal::finish<4>(zonal::polygon_sums<4>(light, rule, in[0], in[1], in[2]),
                     [&](auto, auto, const T& y, const T& gx, const T& gy, const T& gz) {
                       out.insert(out.end(), {y, gx, gy, gz});
                     });
  }
};

/// A light at a position, seen from the origin; normals and tangents fixed, coefficients constants.
template <zonal::Horizon method>
struct HvlRadiance {
  static constexpr const char* name = "hvl_radiance";
  static constexpr double ulps = 300;
  static std::vector<double> sample(Sampler& s) {
    return {s.uniform(-1, 1), s.uniform(-1, 1), s.uniform(0.5, 2), s.uniform(0.05, 0.4)};
  }
  template <class T>
  static void run(const std::vector<T>& in, std::vector<T>& out) {
    constexpr int N = 4, NE = 3;
    zonal::HvlRecord<NE, T> light;
    for (int i = 0; i < 3; ++i) light.position[i] = in[static_cast<std::size_t>(i)];
    set(light.normal, 0.6, 0.0, -0.8);
    set(light.tangent, 0.8, 0.0, 0.6);
    light.radius = in[3];
    zonal::EvenSh<N, glm::vec3> material{};
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < light.emission_size; ++i) light.emission[c][i] = T(std::cos(i + c) * 0.1L + (i == 0));
      for (int i = 0; i < material.size(); ++i) material[i][c] = std::sin(static_cast<float>(2 * i + c + 1));
    }
    zonal::ReceiverFrame<T> frame;
    set(frame.position, 0, 0, 0);
    set(frame.normal, 0, 0, 1);
    set(frame.tangent, 1, 0, 0);
    T radiance[3];
    zonal::hvl_radiance<N, NE, method>(light, frame, material, radiance);
    out.insert(out.end(), radiance, radiance + 3);
  }

 private:
  template <class T>
  static void set(T (&v)[3], double x, double y, double z) {
    v[0] = T(x), v[1] = T(y), v[2] = T(z);
  }
};

}  // namespace kernels
