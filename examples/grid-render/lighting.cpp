#include "band_list.hpp"
#include "lighting_bands.hpp"
#include "planned_lighting.hpp"
#include "shared/input_error.hpp"

namespace example::grid_render {
namespace {

template <class T>
std::unique_ptr<T> built(std::unique_ptr<T> made) {
  if (!made) throw InputError("this number of bands is not compiled in");
  return made;
}

template <class Bands, class Light>
std::unique_ptr<Lighting> make(Lights<Light> lights, int bands) {
  std::unique_ptr<Lighting> made;
  Bands::dispatch(bands, [&](auto n) {
    if constexpr (is_built<n, Light>) made = std::make_unique<LightingOf<n, Light>>(std::move(lights));
  });
  return built(std::move(made));
}

}  // namespace

std::unique_ptr<Lighting> make_lighting(Shape shape, const SphereLights& lights, const LightPanel& panel, int bands) {
  if (shape == Shape::spheres) return make<AllBands>(lights, bands);
  const TriangleLights triangles = triangles_of(lights, panel);
  if (shape == Shape::triangles) return make<TriangleBands>(triangles, bands);
  return make<TriangleBands>(triangle_spheres_of(triangles), bands);
}

std::unique_ptr<PlannedLighting> make_planned_lighting(const SphereLights& lights, int bands) {
  std::unique_ptr<PlannedLighting> made;
  AllBands::dispatch(bands, [&](auto n) {
    if constexpr (is_built<n, Sphere>) made = std::make_unique<PlannedLightingOf<n>>(lights);
  });
  return built(std::move(made));
}

std::unique_ptr<LightGrid> load_light_grid(const std::filesystem::path& path, const Bounds& box, int bands) {
  try {
    const zonal::GridFileHeader header = zonal::read_grid_header(path);
    if (header.bands == bands && (header.low != box.lower || header.high != box.upper)) {
      throw InputError(path.string() + ": is of another scene: its box is not this one's");
    }
    std::unique_ptr<LightGrid> grid;
    AllBands::dispatch(bands, [&](auto n) {
      if constexpr (is_built<n, Sphere>) {
        grid = std::make_unique<LightGridOf<n, GridContent::values_and_gradients>>(zonal::load_grid<n>(path));
      }
    });
    return built(std::move(grid));
  } catch (const zonal::GridFileError& error) {
    throw InputError(one_line(error.what()));
  }
}

std::size_t grid_bytes(int bands, const glm::ivec3& resolution, GridContent content) {
  const int blocks = content == GridContent::values ? 1 : 4;
  return sizeof(float) * static_cast<std::size_t>(blocks * 3 * bands * bands) *
         static_cast<std::size_t>(resolution.x * resolution.y * resolution.z);
}

}  // namespace example::grid_render
