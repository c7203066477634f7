// The registry's entries of the room `light` (kernel_list.hpp).
#pragma once

#include <array>

#include "../light/point.hpp"
#include "../light/polygon.hpp"
#include "../light/sphere.hpp"
#include "../light/triangle.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

namespace detail {
template <class Io>
SphereLight<typename Io::Scalar> take_sphere(Io& io) {
  const auto center = io.vector("center", Domain::light_position);
  return {{center[0], center[1], center[2]}, io.number("radius", Domain::radius)};
}
}  // namespace detail

struct Sphere : Kernel {
  static constexpr const char* name = "project_sphere";
  static constexpr const char* summary = "A sphere light of radiance 1, seen from a receiver.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    project<N>(light, x[0], x[1], x[2], ShOutput<T>{io.template output_sh<N>("sh")});
  }
};

struct SphereWithGradient : Kernel {
  static constexpr const char* name = "project_sphere_with_gradient";
  static constexpr const char* summary = "The same, and the gradient by the receiver's position, per unit of length.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.template output_sh<N>("sh");
    const auto gradient = io.template output_gradient<N>("gradient");
    project_with_gradient<N>(light, x[0], x[1], x[2], GradientOutput<T>{sh, gradient});
  }
};

// ---- Lights that are no shader functions yet: each where it stands --------------------------------------------------

/// Value and gradient of one light, by where the receiver stands.
template <class Entry>
struct LightWithGradient : Kernel {
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.template output_sh<N>("sh");
    const auto gradient = io.template output_gradient<N>("gradient");
    Entry::template project<N>(x, GradientOutput<T>{sh, gradient});
  }
};

struct SpotWithGradient : LightWithGradient<SpotWithGradient> {
  static constexpr const char* name = "project_spot_with_gradient";
  static constexpr const char* summary = "A spotlight at (1/2, -1/4, 3) that shines downwards, and the gradient.";
  template <int N, class T, class Sink>
  static void project(const std::array<T, 3>& x, const Sink& sink) {
    const SpotLight<double> light{{0.5, -0.25, 3}, {0, 0, -1}, 0.96875, 0.25};
    project_with_gradient<N>(light, x[0], x[1], x[2], sink);
  }
};

struct TriangleSphereWithGradient : LightWithGradient<TriangleSphereWithGradient> {
  static constexpr const char* name = "project_triangle_sphere_with_gradient";
  static constexpr const char* summary = "A triangle as a sphere light of radius 1/2, and the gradient.";
  template <int N, class T, class Sink>
  static void project(const std::array<T, 3>& x, const Sink& sink) {
    const TriangleSphereLight<double> light{{0.5, -0.25, 3}, {0, 0.6, 0.8}, 0.5};
    project_with_gradient<N>(light, x[0], x[1], x[2], sink);
  }
};

struct PolygonWithGradient : LightWithGradient<PolygonWithGradient> {
  static constexpr const char* name = "project_polygon_with_gradient";
  static constexpr const char* summary = "A triangle as a polygon light, by a quadrature of three nodes per edge.";
  template <int N, class T, class Sink>
  static void project(const std::array<T, 3>& x, const Sink& sink) {
    static const QuadratureRule rule = gauss_legendre(3);
    const TriangleLight<double> light{{{-1, -1, 2}, {1, -0.5, 2.5}, {0.25, 1, 2}}};
    finish<N>(polygon_sums<N>(light, rule, x[0], x[1], x[2]), sink);
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
