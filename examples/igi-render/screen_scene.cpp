#include "screen_scene.hpp"

#include <algorithm>
#include <utility>

#include <tbb/parallel_for.h>

#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"

namespace example::igi_render {

zonal::SurfacePicture make_surfaces(const PrimaryHits& hits, int width, int height, bool shading_normals) {
  zonal::SurfacePicture surfaces(width, height);
  tbb::parallel_for(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const std::optional<Hit>& hit = hits.of_pixel(pixel)[0];
      if (!hit) continue;
      const glm::vec3& normal = shading_normals ? hit->normal : hit->geometric_normal;
      surfaces.set_surface(x, y, hit->position, normal, hit->distance, hit->mesh, hit->material);
    }
  });
  return surfaces;
}

bool ScreenScene::sees(const Hit& from, const glm::vec3& direction, float distance) const {
  return caster.visible(from, from.position + direction * std::min(distance, 2.0f * diameter));
}

ScreenScene make_screen(const Scene& scene, const RayCaster& caster, const Options& options, const Probe* probe,
                        StageTimes& times, Progress& progress) {
  const int width = options.width * options.antialias, height = options.height * options.antialias;
  std::vector<SplitMaterial> materials;
  times.time(stage_name::materials, [&] {
    for (const Material& material : scene.materials) {
      throw_if_interrupted();
      materials.emplace_back(material);
    }
  });
  std::vector<zonal::LightSet> sets =
      times.time(stage_name::lights, [&] { return make_light_sets(scene, caster, options, probe); });
  PrimaryHits hits = times.time(stage_name::primary, [&] {
    return trace_primary(caster, scene.camera, width, height, {0, height}, 1, {progress, stage_name::primary, 0.0});
  });
  const float radius = bounds_of(scene.mesh).radius();
  const float least_distance = options.least_distance > 0.0f ? options.least_distance : 0.02f * radius;
  zonal::SurfacePicture surfaces = make_surfaces(hits, width, height, false);
  return {scene,          caster,        options, probe,  std::move(materials), std::move(sets),
          least_distance, 2.0f * radius, width,   height, std::move(hits),      std::move(surfaces)};
}

}  // namespace example::igi_render
