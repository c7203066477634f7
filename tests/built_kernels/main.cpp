// Kernels of every room as they are built where no test is built otherwise: by the other compiler, optimised in full,
// for the least processor, without exceptions and type information. A handful of values each, against what they must
// be.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <zonal/basis/gradient.hpp>
#include <zonal/gather/hvl.hpp>
#include <zonal/gather/hvl_zonal.hpp>
#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsgl.hpp>
#include <zonal/gather/vsl.hpp>
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/light/point.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>
#include <zonal/material/brdf.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/zonal.hpp>

#include "../gather/furnace.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;
int failures = 0;

// NaN fails.
void check(const char* what, double value, double expected, double tolerance) {
  if (std::abs(value - expected) <= tolerance) return;
  std::printf("%s: %.9g, and not %.9g to %g\n", what, value, expected, tolerance);
  ++failures;
}

template <class T>
T lane(const T& x) {
  return x;
}
template <class T, int W>
T lane(const zonal::Packet<T, W>& x) {
  return x[W - 1];
}
template <class T, int K>
T lane(const zonal::Dual<T, K>& x) {
  return x.value;
}

template <class Sh>
double square(const Sh& sh) {
  double sum = 0;
  for (const auto& x : sh) sum += static_cast<double>(lane(x)) * static_cast<double>(lane(x));
  return sum;
}

// ---- scalar, basis, lobe, transform ---------------------------------------------------------------------------------

// The squares of all harmonics add up to N^2 / (4 pi), of a degree's gradients to l (l+1) (2l+1) / (4 pi); the
// Laplacian of Y is -l (l+1) Y.
template <int N, class T>
void check_basis(const char* what, double tolerance) {
  const std::array<T, 3> v{T(0.48F), T(0.6F), T(0.64F)};
  check(what, square(zonal::evaluate<N>(v)), N * N / (4 * pi), tolerance);
  const auto y = zonal::evaluate_with_gradient<N>(v);
  double expected = 0;
  for (int l = 0; l < N; ++l) expected += l * (l + 1) * (2 * l + 1) / (4 * pi);
  check(what, square(y.value), N * N / (4 * pi), tolerance);
  check(what, square(y.gradient[0]) + square(y.gradient[1]) + square(y.gradient[2]), expected, expected * tolerance);
}

void check_hessian() {
  constexpr int N = 4;
  const auto y = zonal::evaluate_with_hessian<N>(std::array<double, 3>{0.48, 0.6, 0.64});
  for (int l = 0; l < N; ++l) {
    for (int m = -l; m <= l; ++m) {
      check("Laplacian", y.hessian[0](l, m) + y.hessian[3](l, m) + y.hessian[5](l, m), -l * (l + 1) * y.value(l, m),
            1e-12);
    }
  }
}

// A lobe's integral is sqrt(4 pi) z_0, and turned about it is the same lobe.
template <class T>
void check_lobes(const char* what, double tolerance) {
  const auto cap = zonal::project<4>(zonal::SphericalCap<T>{T(0.5F), T(std::sqrt(0.75F))});
  check(what, std::sqrt(4 * pi) * static_cast<double>(lane(cap[0])), pi, tolerance);
  const auto turned = zonal::orient(cap, std::array<T, 3>{T(0.48F), T(0.6F), T(0.64F)});
  check(what, square(turned), square(cap), tolerance);
  const auto lambert = zonal::project<4, T>(zonal::LambertLobe{});
  check(what, std::sqrt(4 * pi) * static_cast<double>(lane(lambert[0])), 1, tolerance);
  check(what, static_cast<double>(lane(zonal::dot(turned, turned))), square(cap), tolerance);
  check(what, static_cast<double>(lane(zonal::convolve(turned, lambert)[0])), static_cast<double>(lane(turned[0])),
        tolerance);
}

// ---- light ----------------------------------------------------------------------------------------------------------

// The solid angle is sqrt(4 pi) times the first coefficient; the gradient is what central differences find.
template <class Light>
void check_light(const char* what, const Light& light, const glm::dvec3& x, double solid_angle) {
  constexpr int N = 3;
  const auto y = zonal::project_with_gradient<N>(light, x);
  check(what, std::sqrt(4 * pi) * zonal::project<N>(light, x)[0], solid_angle, 1e-6 * solid_angle);
  check(what, std::sqrt(4 * pi) * y.value[0], solid_angle, 1e-6 * solid_angle);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = 1e-4;
    const auto high = zonal::project<N>(light, x + step), low = zonal::project<N>(light, x - step);
    for (int i = 0; i < N * N; ++i) check(what, y.gradient[axis][i], (high[i] - low[i]) / 2e-4, 1e-5);
  }
}

void check_lights() {
  check_light("sphere", zonal::SphereLight<double>{glm::dvec3(0, 0, 2), 1}, glm::dvec3(0.0),
              2 * pi * (1 - std::sqrt(0.75)));
  // An octant.
  check_light("triangle", zonal::TriangleLight<double>{{glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)}},
              glm::dvec3(0.0), pi / 2);
  // Of intensity 1: 1 / d^2.
  check_light("point", zonal::PointLight<double>{glm::dvec3(0, 1, 2)}, glm::dvec3(0.0), 0.2);
}

// ---- grid -----------------------------------------------------------------------------------------------------------

const auto serially = [](int count, const auto& body) {
  for (int i = 0; i < count; ++i) body(i);
};

// What packets of vertices hold is what one receiver sees; Hermite's weights at a vertex take just that.
template <class Light, class Add>
void check_grid(const char* what, const Light& light, const Add& add) {
  constexpr int N = 2;
  zonal::CoefficientGrid<N> grid({-1, -1, -1}, {1, 1, 1}, glm::ivec3(3));
  add(grid, std::vector<zonal::ColouredLight<Light>>{{light, glm::vec3(1, 2, 3)}});
  const glm::ivec3 vertex(2, 1, 0);
  const auto expected = zonal::project<N>(light, grid.position(vertex));
  const auto hermite = zonal::interpolate<zonal::Interpolation::hermite>(grid, grid.position(vertex));
  for (int i = 0; i < N * N; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double exact = (c + 1) * static_cast<double>(expected[i]);
      check(what, static_cast<double>(grid.value(vertex)[i][c]), exact, 2e-6);
      check(what, static_cast<double>(hermite[i][c]), exact, 2e-6);
    }
  }
}

// ---- material, gather -----------------------------------------------------------------------------------------------

// In a white furnace a white wall reflects what it receives, by every gather.
void check_gathers() {
  using zonal::Vsgl;
  const zonal::Brdf white{{zonal::LambertBrdf{glm::vec3(1)}}};
  const zonal::MaterialTable table(zonal::project_material(white, 3));
  const zonal::ZonalTable zonal_table(zonal::project_zonal(white, 3));
  constexpr int side = 10;
  const auto lights = gather_test::furnace(side * side, white, table);
  const zonal::LightCache cache(lights);
  const zonal::HvlCache<1> harmonics(lights);
  const zonal::GaussianCache gaussians(zonal::make_gaussian_lights(lights.data(), side, 1)),
      gaussians_2024(zonal::make_gaussian_lights<Vsgl::of_2024>(lights.data(), side, 1));
  std::mt19937 engine(6);
  const auto uniform = [&engine] { return static_cast<float>(engine() >> 8) * 0x1p-24F; };
  const auto energy = [&](const char* what, double tolerance, const auto& gather) {
    check(what, gather_test::furnace_energy(table, 30, 20, gather), 1, tolerance);
  };
  using zonal::Receiver;
  energy("vpl", 0.001, [&](const Receiver& r) { return zonal::gather_vpl(cache, r, white); });
  energy("vsl", 0.1, [&](const Receiver& r) { return zonal::gather_vsl(cache, r, white, 16, uniform); });
  energy("vsgl", 0.25, [&](const Receiver& r) { return zonal::gather_vsgl(gaussians, r, white); });
  energy("vsgl of 2024", 0.06,
         [&](const Receiver& r) { return zonal::gather_vsgl<Vsgl::of_2024>(gaussians_2024, r, white); });
  energy("hvl", 0.1, [&](const Receiver& r) { return zonal::gather<3>(harmonics, r, table); });
  energy("hvl-zonal", 0.1, [&](const Receiver& r) { return zonal::gather_hvl_zonal<3>(cache, r, zonal_table); });
}

}  // namespace

int main() {
  check_basis<4, float>("float", 1e-5);
  check_basis<4, double>("double", 1e-7);  // its direction is of unit length in float
  check_basis<4, zonal::Packet<float, 4>>("packet of 4", 1e-5);
  check_basis<4, zonal::Packet<float, zonal::kNativeLanes>>("native packet", 1e-5);
  check_basis<3, zonal::Dual<double, 1>>("dual number", 1e-7);
  check_hessian();
  check_lobes<float>("lobes in float", 1e-5);
  check_lobes<double>("lobes in double", 1e-6);
  check_lobes<zonal::Packet<float, zonal::kNativeLanes>>("lobes in packets", 1e-5);
  check_lights();
  check_grid("grid of a sphere", zonal::SphereLight<float>{{0, 0, 2.5F}, 0.5F},
             [](auto& grid, const auto& lights) { zonal::add_lights(grid, lights, serially); });
  check_grid("grid of a triangle", zonal::TriangleLight<float>{{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}},
             [](auto& grid, const auto& lights) { zonal::add_lights(grid, lights, 1e-6, serially); });
  check_gathers();
  if (failures == 0) std::puts("all as they must be");
  return failures == 0 ? 0 : 1;
}
