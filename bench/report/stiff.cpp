// Stiff inputs: the papers' formulas and this library's where distances, sizes and degrees are extreme.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>
#include <zonal/lobe/cap_closed_form.hpp>
#include <zonal/lobe/cap_reference.hpp>
#include <zonal/many_bands/gradient.hpp>
#include <zonal/many_bands/lobes.hpp>

#include "../rivals.hpp"
#include "report.hpp"

namespace zonal_report {
namespace {

constexpr int N = 10, most_bands = 250;

/// body(x) for x from 10^low to 10^high, so many to a decade.
template <class Body>
void for_each_power(double low, double high, int per_decade, const Body& body) {
  const int steps = int((high - low) * per_decade + 0.5);
  for (int i = 0; i <= steps; ++i) body(std::pow(10.0, low + (high - low) * i / steps));
}

constexpr double no_number = 1e9;

/// Greatest difference over the greatest number; no_number where one is none.
template <class Values, class Exact>
double relative_error(const Values& got, const Exact& exact, int size) {
  double error = 0, greatest = 0;
  for (int i = 0; i < size; ++i) {
    if (!std::isfinite(double(got[i]))) return no_number;
    error = std::max(error, std::abs(double(got[i]) - double(exact[i])));
    greatest = std::max(greatest, std::abs(double(exact[i])));
  }
  return error / greatest;
}

/// Of caps, by the sine of the half angle: of a sphere light its radius over its distance.
void print_caps(int per_decade) {
  for_each_power(-8, 0, per_decade, [](double x) {
    const auto sine = float(x);
    const auto cap = zonal::SphericalCap<float>::from_sphere(1.0F, sine);
    const auto exact = zonal::project<N>(zonal::SphericalCap<long double>::from_sphere(1.0L, sine));
    print_row("cap", "differences", x, relative_error(zonal::project<N>(cap), exact, N));
    print_row("cap", "legendre", x, relative_error(zonal::reference::project_cap_legendre<N>(cap.cos_angle), exact, N));
    print_row("cap", "closed", x,
              relative_error(zonal::reference::project_cap_closed_form<N>(cap.cos_angle), exact, N));
  });
}

/// Of gradients, by the sine of the distance from the pole.
void print_gradients(int per_decade) {
  for_each_power(-24, 0, per_decade, [](double x) {
    const std::array<float, 3> v{float(0.6 * x), float(0.8 * x), float(std::sqrt(1 - x * x))};
    const std::array<long double, 3> wide{v[0], v[1], v[2]};
    const auto exact = zonal::evaluate_with_gradient<N>(wide);
    const auto print = [&](const char* form, const auto& got) {
      double worst = 0;
      for (int k = 0; k < 2; ++k) worst = std::max(worst, relative_error(got.gradient[k], exact.gradient[k], N * N));
      print_row("gradient", form, x, worst);
    };
    print("ladder", zonal::evaluate_with_gradient<N>(v));
    print("sloan_like", zonal_bench::SloanLike::of<N>(v));
    print("direct", zonal_bench::Direct::of<N>(v));
  });
}

/// The solid angle of a triangle as [gradient paper, Eq. 25] has it, unit vectors to its corners.
float plain_solid_angle(const zonal::TriangleLight<float>& light) {
  const glm::vec3 a = glm::normalize(light.vertices[0]), b = glm::normalize(light.vertices[1]),
                  c = glm::normalize(light.vertices[2]);
  return 2 * std::atan2(std::abs(glm::dot(a, glm::cross(b, c))), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

/// Of a triangle's solid angle, by its distance over its size.
void print_solid_angles(int per_decade) {
  for_each_power(0, 8, per_decade, [](double x) {
    const auto d = float(x);
    const zonal::TriangleLight<float> light{{{-0.5F, 0.1F * d, d}, {0.5F, 0.1F * d, d}, {0.1F, 0.1F * d + 0.8F, d}}};
    zonal::TriangleLight<long double> wide;
    for (int v = 0; v < 3; ++v) wide.vertices[v] = glm::vec<3, long double>(light.vertices[v]);
    const auto coefficient = [](const auto& triangle, const auto& at) {
      return zonal::project_with_gradient<1>(triangle, at, 1e-7).value[0];
    };
    const double exact = double(coefficient(wide, glm::vec<3, long double>(0)));
    const auto print = [&](const char* form, double got) {
      print_row("solid_angle", form, x, std::abs(got / exact - 1));
    };
    print("edges", double(coefficient(light, glm::vec3(0))));
    print("corners", double(plain_solid_angle(light)) * double(zonal::detail::zonal_normalisation<0>));
    const auto sphere = zonal::TriangleSphereLight<float>::approximate(light);
    print("sphere", double(zonal::project<1>(sphere, glm::vec3(0))[0]));
  });
}

/// Of each recurrence in float, by degree: in units of the degree's largest value, of lobes of their largest
/// coefficient.
void print_degrees(int bands, int directions) {
  const zonal::ManyBands<float> narrow(bands);
  const zonal::ManyBands<double> wide(bands);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> worst(std::size_t(bands), 0), plain(worst);
  const auto table = std::make_unique<zonal::BasisTable<most_bands>>();
  for (int i = 0; i < directions; ++i) {
    const double sine = i % 2 == 0 ? std::pow(10.0, 2 * uniform(random) - 2) : std::abs(uniform(random));
    const double turn = 3.14159265 * uniform(random);
    const std::array<float, 3> v{float(sine * std::cos(turn)), float(sine * std::sin(turn)),
                                 float(std::sqrt(std::max(0.0, 1 - sine * sine)))};
    const std::array<double, 3> same{double(v[0]), double(v[1]), double(v[2])};
    const auto got = zonal::evaluate(narrow, v);
    const auto exact = zonal::evaluate(wide, same);
    // The recurrence in z, column by column, as the unrolled form has it.
    float c = 1, s = 0;
    for (int m = 0; m < bands; ++m) {
      float below = 0, last = 0;
      for (int l = m; l < bands; ++l) {
        const float raise = float(table->raise[l][m]), lower = float(table->lower[l][m]);
        const float next =
            l == m ? float(table->diagonal[m]) : zonal::detail::next_legendre(raise, lower, v[2], last, below);
        below = last, last = next;
        const double unit = std::sqrt((2 * l + 1) / (4 * 3.14159265358979));
        const auto degree = std::size_t(l);
        worst[degree] = std::max(worst[degree], std::abs(double(got(l, m)) - exact(l, m)) / unit);
        const double error = std::abs(double(next * c) - exact(l, m)) / unit;
        plain[degree] = std::max(plain[degree], std::isfinite(error) ? error : no_number);
      }
      zonal::detail::turn(v[0], v[1], c, s);
    }
  }
  const auto print_lobe = [&](const char* form, const auto& got, const auto& exact) {
    double greatest = 0;
    for (int l = 0; l < bands; ++l) greatest = std::max(greatest, std::abs(double(exact[l])));
    for (int l = 1; l < bands; ++l) {
      print_row("degree", form, l, std::max(std::abs(double(got[l]) - double(exact[l])) / greatest, 1e-10));
    }
  };
  for (int l = 1; l < bands; ++l) {
    print_row("degree", "basis", l, std::max(worst[std::size_t(l)], 1e-10));
    print_row("degree", "in_z", l, std::max(plain[std::size_t(l)], 1e-10));
  }
  const auto sine = 0.3F;
  const auto cap = zonal::SphericalCap<float>::from_sphere(1.0F, sine);
  const auto wide_cap = zonal::SphericalCap<double>::from_sphere(1.0, double(sine));
  print_lobe("cap", zonal::project(narrow, cap), zonal::project(wide, wide_cap));
  print_lobe("cap_derivative", zonal::project_derivative(narrow, cap), zonal::project_derivative(wide, wide_cap));
  print_lobe("phong", zonal::project(narrow, zonal::PhongLobe<float>{1000.0F}),
             zonal::project(wide, zonal::PhongLobe<double>{1000.0}));
  print_lobe("gaussian", zonal::project(narrow, zonal::SphericalGaussian<float>{1000.0F}),
             zonal::project(wide, zonal::SphericalGaussian<double>{1000.0}));
}

/// A sphere light of radius 1 from a place: its degrees of order 0 in units of their largest value, and the length of
/// their gradients.
void print_sphere(const char* plot, double x, const glm::vec3& place) {
  const zonal::SphereLight<float> light{{0, 0, 0}, 1};
  const auto sh = zonal::project_with_gradient<4>(light, place);
  constexpr std::array values{"value 0", "value 1", "value 2", "value 3"};
  constexpr std::array slopes{"gradient 0", "gradient 1", "gradient 2", "gradient 3"};
  for (int l = 0; l < 4; ++l) {
    const glm::dvec3 gradient(sh.gradient[0](l, 0), sh.gradient[1](l, 0), sh.gradient[2](l, 0));
    print_row(plot, values[std::size_t(l)], x, sh.value(l, 0));
    print_row(plot, slopes[std::size_t(l)], x, glm::length(gradient));
  }
}

void print_ways(int per_decade) {
  const glm::vec3 direction = glm::normalize(glm::vec3(0.3F, -0.5F, 0.8F));
  // Through the surface: the height above it, in radii, and below it as negative.
  for (const double side : {-1.0, 1.0}) {
    for_each_power(-7, 0, per_decade, [&](double height) {
      print_sphere("pan", side * height, float(1 + side * height * (side < 0 ? 0.999 : 1)) * direction);
    });
  }
  for (const double side : {-1.0, 1.0}) {
    for_each_power(-2, 6, per_decade, [&](double along) {
      print_sphere("fly_by", side * along, {1.001F, 0, float(side * along)});
    });
  }
}

}  // namespace

void print_stiff(Effort effort) {
  const int per_decade = choose(effort, 2, 12, 40);
  print_row("plot", "form", "x", "y");
  print_caps(per_decade);
  print_gradients(per_decade);
  print_solid_angles(per_decade);
  print_degrees(choose(effort, 20, most_bands, most_bands), choose(effort, 20, 2000, 20000));
  print_ways(per_decade);
}

}  // namespace zonal_report
