#include "grid_light.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/screen/shade.hpp>
#include <zonal/transform/convolve.hpp>

#include "shared/input_error.hpp"

namespace example::field_render {
namespace {

using zonal::GridContent;
using zonal::Interpolation;

constexpr int least_bands = 3, most_bands = 6;

/// call(std::integral_constant<int, n>) for n from `first` to `last`.
template <int first, int last, class Call>
auto with_number(int n, const Call& call) {
  if constexpr (first < last) {
    if (n > first) return with_number<first + 1, last>(n, call);
  }
  return call(std::integral_constant<int, first>{});
}

/// The albedo of a body of Lambert's lobes alone.
std::optional<glm::vec3> matte_albedo(const zonal::Brdf& body) {
  glm::vec3 albedo(0.0f);
  for (const zonal::BrdfLobe& lobe : body.lobes) {
    const auto* lambert = std::get_if<zonal::LambertBrdf>(&lobe);
    if (lambert == nullptr) return std::nullopt;
    albedo += lambert->albedo;
  }
  return albedo;
}

template <int N>
glm::vec3 by_table(const zonal::Sh<N, glm::vec3>& radiance, const Hit& hit, const glm::vec3& outgoing,
                   const SplitMaterial& material, const GlossShading& shading) {
  return with_number<1, N>(shading.bands, [&](auto n) {
    constexpr int used = decltype(n)::value;
    const auto row = material.row<used>(hit.colour, glm::dot(hit.normal, outgoing), shading.window);
    return zonal::reflected_radiance(zonal::in_shading_frame(zonal::with_bands<used>(radiance), hit.normal, outgoing),
                                     row);
  });
}

template <int N, GridContent content, Interpolation method>
class GridLightOf final : public GridLight {
 public:
  using Grid = zonal::CoefficientGrid<N, content>;
  explicit GridLightOf(Grid grid) : grid_(std::move(grid)) {}

  Bounds box() const override { return {grid_.low(), grid_.high()}; }
  glm::ivec3 resolution() const override { return grid_.resolution(); }
  int bands() const override { return N; }

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const SplitMaterial& material,
                      const GlossShading& shading) const override {
    const auto radiance = zonal::interpolate<method>(grid_, hit.position);
    const std::optional<glm::vec3> albedo = matte_albedo(material.body);
    if (!albedo || !material.rest.lobes.empty()) return by_table(radiance, hit, outgoing, material, shading);
    const glm::vec3 over_pi =
        zonal::reconstruct_convolved(zonal::with_bands<3>(radiance), zonal::LambertLobe{}, hit.normal);
    return *albedo * hit.colour * glm::max(over_pi, glm::vec3(0.0f));
  }

 private:
  Grid grid_;
};

template <int N>
std::unique_ptr<GridLight> load(const std::filesystem::path& path, GridContent content, Interpolation interpolation) {
  constexpr auto both = GridContent::values_and_gradients;
  if (content == GridContent::values) {
    return std::make_unique<GridLightOf<N, GridContent::values, Interpolation::trilinear>>(
        zonal::load_grid<N, GridContent::values>(path));
  }
  if (interpolation == Interpolation::trilinear) {
    return std::make_unique<GridLightOf<N, both, Interpolation::trilinear>>(zonal::load_grid<N>(path));
  }
  return std::make_unique<GridLightOf<N, both, Interpolation::hermite>>(zonal::load_grid<N>(path));
}

}  // namespace

std::unique_ptr<GridLight> load_grid_light(const std::filesystem::path& path, Interpolation interpolation) {
  check_is_file(path);
  try {
    const zonal::GridFileHeader header = zonal::read_grid_header(path);
    if (header.bands < least_bands || header.bands > most_bands) {
      throw InputError(path.string() + ": has " + std::to_string(header.bands) + " bands, not " +
                       std::to_string(least_bands) + " to " + std::to_string(most_bands));
    }
    if (header.content == GridContent::values && interpolation != Interpolation::trilinear) {
      throw InputError(path.string() + ": has no gradients, which --interpolation hermite needs");
    }
    return with_number<least_bands, most_bands>(
        header.bands, [&](auto n) { return load<decltype(n)::value>(path, header.content, interpolation); });
  } catch (const zonal::FileError& error) {
    throw InputError(one_line(error.what()));
  }
}

}  // namespace example::field_render
