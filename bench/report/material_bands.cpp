// What N bands of a material miss: the relative L2 error over the hemisphere, times the cosine.
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <zonal/material/material_table.hpp>

#include "materials.hpp"
#include "report.hpp"

namespace zonal_report {
namespace {

using zonal::Window;
constexpr int most_bands = zonal::MaterialTable::max_bands;
constexpr std::array windows{Window::none, Window::hann, Window::sinc};
constexpr const char* window_names[] = {"none", "hann", "sinc"};
constexpr double angles[] = {0, 30, 60, 75};  // outgoing, degrees

// Squared errors over the hemisphere by window and number of bands, and the square of the function itself.
struct Squares {
  double errors[windows.size()][std::size_t{most_bands}] = {}, function = 0;
};

using Coefficients = zonal::EvenSh<most_bands, glm::dvec3>;

// Adds one node: `exact` is the function there, `scale` what both sides are multiplied by.
void add_node(const Coefficients& coefficients, const zonal::EvenSh<most_bands, double>& basis, const glm::dvec3& exact,
              double scale, double solid_angle, Squares& squares) {
  glm::dvec3 by_degree[std::size_t{most_bands}] = {};
  for (int l = 0, i = 0; l < most_bands; ++l) {
    for (int m = 0; m <= l; ++m, ++i) by_degree[l] += coefficients[i] * basis[i];
  }
  const auto square = [&](const glm::dvec3& rgb) { return glm::dot(rgb, rgb) * scale * scale * solid_angle; };
  squares.function += square(exact);
  for (std::size_t w = 0; w < windows.size(); ++w) {
    for (int bands = 1; bands <= most_bands; ++bands) {
      glm::dvec3 sum(0);
      for (int l = 0; l < bands; ++l) sum += by_degree[l] * zonal::window_factor(windows[w], l, bands);
      squares.errors[w][bands - 1] += square(sum - exact);
    }
  }
}

// Errors of F, which holds the cosine, and of F', which is multiplied by it.
struct Errors {
  double receiver[windows.size()][std::size_t{most_bands}] = {}, emitter[windows.size()][std::size_t{most_bands}] = {};
};

void add_angle(const zonal::Brdf& brdf, double degrees, const zonal::ProjectionQuadrature& quadrature, int level,
               Errors& errors) {
  const double theta_o = degrees / 180 * double(zonal::kPi);
  const glm::dvec3 wo(std::sin(theta_o), 0, std::cos(theta_o));
  const auto f = [&](const glm::dvec3& wi, const glm::dvec3& eye) { return zonal::evaluate(brdf, wi, eye); };
  const auto projection = zonal::project_brdf<most_bands>(f, wo.z, 1e-4, quadrature);
  Squares receiver, emitter;
  zonal::for_each_mirror_node(theta_o, quadrature.rule(level), [&](const glm::dvec3& wi, double solid_angle) {
    const auto basis = zonal::evaluate_even<most_bands>(wi.x, wi.z);
    const glm::dvec3 exact = f(wi, wo);
    add_node(projection.with_cosine, basis, exact * wi.z, 1, solid_angle, receiver);
    add_node(projection.without_cosine, basis, exact, wi.z, solid_angle, emitter);
  });
  for (std::size_t w = 0; w < windows.size(); ++w) {
    for (std::size_t b = 0; b < std::size_t{most_bands}; ++b) {
      errors.receiver[w][b] += std::sqrt(receiver.errors[w][b] / receiver.function) / std::size(angles);
      errors.emitter[w][b] += std::sqrt(emitter.errors[w][b] / emitter.function) / std::size(angles);
    }
  }
}

}  // namespace

void print_materials(Effort effort) {
  print_row("material", "source", "quantity", "window", "bands", "error");
  const zonal::ProjectionQuadrature quadrature;
  for (const NamedMaterial& material : all_materials()) {
    Errors errors;
    for (const double degrees : angles) {
      add_angle(material.brdf, degrees, quadrature, choose(effort, 0, 1, 2), errors);
    }
    for (std::size_t w = 0; w < windows.size(); ++w) {
      for (int bands = 1; bands <= most_bands; ++bands) {
        const auto print = [&](const char* quantity, double error) {
          print_row(material.name, material.source, quantity, window_names[w], bands, error);
        };
        print("receiver", errors.receiver[w][bands - 1]);
        print("emitter", errors.emitter[w][bands - 1]);
      }
    }
  }
}

}  // namespace zonal_report
