#include "reflector.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <tbb/parallel_for.h>
#include <glm/gtc/constants.hpp>

#include "shared/interrupt.hpp"

namespace example::grid_render {
namespace {

constexpr double projection_tolerance = 1e-4;

zonal::BrdfLobe without_colour(const zonal::GgxBrdf& lobe) {
  return zonal::GgxBrdf{lobe.roughness, zonal::SchlickFresnel{glm::vec3(1.0f)}};
}
zonal::BrdfLobe without_colour(const zonal::PhongBrdf& lobe) {
  return zonal::PhongBrdf{glm::vec3(1.0f), lobe.exponent};
}
/// Measured, or unknown: the shape of its red channel stands for all.
template <class Lobe>
zonal::BrdfLobe without_colour(const Lobe& lobe) {
  return lobe;
}

using Kernel = zonal::Zh<most_lobe_bands, float>;

/// Seen from the normal a lobe is zonal: the coefficients of m = 0 are all there is.
Kernel kernel_of(const zonal::EvenSh<most_lobe_bands, glm::dvec3>& projection, double integral,
                 const Options& options) {
  const int bands = std::min(options.bands, options.lobe_bands);
  Kernel kernel{};
  for (int l = 0; l < bands; ++l) {
    const double factor = zonal::window_factor(options.window, l, bands);
    kernel[l] = static_cast<float>(factor * projection(l, 0).r / integral);
  }
  return kernel;
}

template <class Lobe>
GlossyLobe glossy_lobe(const Lobe& lobe, const Options& options) {
  const zonal::BrdfLobe white = without_colour(lobe);
  const auto brdf = [&](const glm::dvec3& wi, const glm::dvec3& wo) { return zonal::evaluate(white, wi, wo); };
  const auto projection = zonal::project_brdf<most_lobe_bands>(brdf, 1.0, projection_tolerance);
  const double integral = std::sqrt(4.0 * glm::pi<double>()) * projection.with_cosine(0, 0).r;
  const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };
  return {kernel_of(projection.with_cosine, integral, options), kernel_of(projection.without_cosine, integral, options),
          zonal::project_material(zonal::Brdf{{lobe}}, 1, projection_tolerance, for_each)};
}

void add_lobe(Reflector& reflector, const zonal::LambertBrdf& lobe, const Options&) {
  reflector.diffuse_albedo += lobe.albedo;
}

/// From wherever it is seen, as from the mean of all directions.
void add_lobe(Reflector& reflector, const zonal::ResidualBrdf& lobe, const Options&) {
  reflector.diffuse_albedo += lobe.albedo * lobe.mean;
}

template <class Lobe>
void add_lobe(Reflector& reflector, const Lobe& lobe, const Options& options) {
  reflector.glossy.push_back(glossy_lobe(lobe, options));
}

}  // namespace

std::vector<Reflector> project_materials(const std::vector<Material>& materials, const Options& options) {
  std::vector<Reflector> reflectors;
  for (const Material& material : materials) {
    Reflector& reflector = reflectors.emplace_back();
    for (const zonal::BrdfLobe& lobe : material.brdf.lobes) {
      throw_if_interrupted();
      std::visit([&](const auto& model) { add_lobe(reflector, model, options); }, lobe);
    }
  }
  return reflectors;
}

}  // namespace example::grid_render
