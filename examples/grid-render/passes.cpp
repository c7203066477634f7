#include "passes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "option_names.hpp"

namespace example::grid_render {
namespace {

/// Values alone at so many vertices take about the memory of values and gradients at `resolution`: four times as many.
glm::ivec3 equal_memory(const glm::ivec3& resolution) {
  return glm::ivec3(glm::round(std::cbrt(4.0f) * glm::vec3(resolution)));
}

Pass pass_on_grid(const std::string& name, Shape shape, zonal::Interpolation method, const glm::ivec3& resolution) {
  return {name, {shape, method}, GridFacts{resolution, 0, 0.0}};
}

Pass pass_without_grid(const std::string& name, Shape shape) { return {name, {shape, std::nullopt}}; }

Pass pass_by_paths(const std::string& name, const Options& options, bool is_visible) {
  Pass pass = pass_on_grid(name, Shape::spheres, zonal::Interpolation::trilinear, options.grid);
  pass.technique.is_visible = is_visible;
  return pass;
}

/// Paths at every point, and on a grid with plain weights and by what is seen.
std::vector<Pass> passes_by_paths(const Options& options) {
  if (!options.comparing()) return {pass_by_paths("picture", options, options.is_visible)};
  return {pass_without_grid("reference", Shape::spheres), pass_by_paths("trilinear", options, false),
          pass_by_paths("visible", options, true)};
}

std::vector<Pass> single_pass(const Options& options) {
  const std::string name = "picture";
  if (!options.method) return {pass_without_grid(name, options.shape)};
  return {pass_on_grid(name, options.shape, *options.method, options.grid)};
}

std::vector<Pass> passes_by_interpolation(const Options& options) {
  using zonal::Interpolation;
  const Shape shape = options.shape;
  return {pass_without_grid("reference", shape),
          pass_on_grid("trilinear", shape, Interpolation::trilinear, options.grid),
          pass_on_grid("taylor", shape, Interpolation::taylor, options.grid),
          pass_on_grid("hermite", shape, Interpolation::hermite, options.grid),
          pass_on_grid("trilinear-equal-memory", shape, Interpolation::trilinear, equal_memory(options.grid))};
}

/// Each shape without a grid and on one.
std::vector<Pass> passes_by_shape(const Options& options) {
  std::vector<Pass> passes{{"spheres-zonal", {Shape::spheres, std::nullopt, true}}};
  for (const auto& [name, shape] : shape_names) {
    passes.push_back(pass_without_grid(name, shape));
    passes.push_back(pass_on_grid(name + "-hermite", shape, zonal::Interpolation::hermite, options.grid));
  }
  return passes;
}

std::vector<Comparison> comparisons_by_shape(const std::vector<Pass>& passes) {
  const auto number = [&](const std::string& name) {
    const auto found = std::find_if(passes.begin(), passes.end(), [&](const Pass& pass) { return pass.name == name; });
    return static_cast<std::size_t>(found - passes.begin());
  };
  std::vector<Comparison> comparisons;
  for (const auto& [picture, reference] :
       std::vector<std::pair<std::string, std::string>>{{"spheres-zonal", "spheres"},
                                                        {"spheres-hermite", "spheres"},
                                                        {"spheres", "triangles"},
                                                        {"triangle-spheres", "triangles"},
                                                        {"spheres-hermite", "triangles"},
                                                        {"triangle-spheres-hermite", "triangles"},
                                                        {"triangles-hermite", "triangles"},
                                                        {"spheres-hermite", "triangles-hermite"},
                                                        {"triangle-spheres-hermite", "triangles-hermite"}}) {
    comparisons.push_back({number(picture), number(reference), picture + "-against-" + reference});
  }
  return comparisons;
}

}  // namespace

std::vector<Pass> passes_of(const Options& options) {
  if (options.paths > 0) return passes_by_paths(options);
  if (!options.comparing()) return single_pass(options);
  return options.comparing_shapes ? passes_by_shape(options) : passes_by_interpolation(options);
}

std::vector<Comparison> comparisons_of(const Options& options, const std::vector<Pass>& passes) {
  if (options.comparing_shapes) return comparisons_by_shape(passes);
  std::vector<Comparison> comparisons;
  for (std::size_t i = 1; i < passes.size(); ++i) comparisons.push_back({i, 0, passes[i].name + "-difference"});
  return comparisons;
}

}  // namespace example::grid_render
