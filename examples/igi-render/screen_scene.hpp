#pragma once

#include <vector>

#include <zonal/screen/incident.hpp>
#include <zonal/screen/surface.hpp>

#include "light_sets.hpp"
#include "options.hpp"
#include "shared/materials.hpp"
#include "shared/primary_hits.hpp"
#include "shared/progress.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"
#include "shared/split_material.hpp"
#include "shared/stage_times.hpp"

namespace example::igi_render {

namespace stage_name {
using namespace example::stage_name;
inline constexpr const char* lights = "sets of lights";
}  // namespace stage_name

/// All that the filters need, made once: what each position of the picture sees, and the lights.
struct ScreenScene {
  const Scene& scene;
  const RayCaster& caster;
  const Options& options;
  const Probe* probe;
  std::vector<SplitMaterial> materials;
  std::vector<zonal::LightSet> sets;
  float least_distance;  // metres
  float diameter;        // of the scene, metres

  int width, height;               // positions
  PrimaryHits hits;                // one at each
  zonal::SurfacePicture surfaces;  // with geometric normals

  const std::optional<Hit>& hit_at(int x, int y) const {
    return hits.of_pixel(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x))[0];
  }

  /// Is the way free from the hit?
  bool sees(const Hit& from, const glm::vec3& direction, float distance) const;
};

/// What the hits see, with geometric normals or those that it is shaded by.
zonal::SurfacePicture make_surfaces(const PrimaryHits& hits, int width, int height, bool shading_normals);

/// Scene, caster, options and probe, null where there is none, must outlive it.
ScreenScene make_screen(const Scene& scene, const RayCaster& caster, const Options& options, const Probe* probe,
                        StageTimes& times, Progress& progress);

}  // namespace example::igi_render
