#include "fields.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "paths.hpp"
#include "zonal_field.hpp"

namespace example::grid_render {

Fields::Fields(const Scene& scene, const RayCaster& caster, const SphereLights& lights, const Report& report,
               std::unique_ptr<LightGrid> loaded)
    : scene_(scene), caster_(caster), lights_(lights), options_(report.options), box_(report.box) {
  if (!loaded) return;
  const glm::ivec3 resolution = loaded->resolution();
  made_.push_back({options_.shape, resolution, GridContent::values_and_gradients, 0.0, std::move(loaded)});
}

std::unique_ptr<LightField> Fields::field(Pass& pass) {
  const Technique& technique = pass.technique;
  if (options_.load_grid.empty()) pass.lights = lighting(technique.shape).light_count();
  if (technique.is_zonal) return make_zonal_field(lights_, options_.bands);
  if (!pass.grid) return lighting(technique.shape).exact();
  const Made& made = grid(pass);
  pass.grid->seconds = made.seconds;
  pass.grid->bytes = grid_bytes(options_.bands, made.resolution, made.content);
  pass.grid->visibility_bytes = made.grid->visibility_bytes();
  return technique.is_visible ? made.grid->visible() : made.grid->interpolated(*technique.method);
}

const Lighting& Fields::lighting(Shape shape) {
  std::unique_ptr<Lighting>& made = lightings_[shape];
  if (made) return *made;
  made = options_.paths > 0 ? make_path_lighting(scene_, caster_, lights_, options_.bands, options_.paths)
                            : make_lighting(shape, lights_, scene_.panel, options_.bands);
  return *made;
}

/// In a file a grid has its gradients, whatever this run interpolates by.
GridContent Fields::content_of(zonal::Interpolation method) const {
  if (options_.paths > 0) return GridContent::values;
  const bool has_file = !options_.save_grid.empty() || !options_.load_grid.empty();
  return zonal::blocks_read(method) > 1 || has_file ? GridContent::values_and_gradients : GridContent::values;
}

const Fields::Made& Fields::grid(const Pass& pass) {
  const Shape shape = pass.technique.shape;
  const GridContent content = content_of(*pass.technique.method);
  const glm::ivec3& resolution = pass.grid->resolution;
  for (const Made& made : made_) {
    if (made.shape == shape && made.resolution == resolution && made.content == content) return made;
  }
  return made_.emplace_back(build(shape, resolution, content));
}

/// Of several builds of a grid, the fastest counts where times are compared: the first also wakes threads and memory.
Fields::Made Fields::build(Shape shape, const glm::ivec3& resolution, GridContent content) {
  Made made{shape, resolution, content, std::numeric_limits<double>::infinity(), nullptr};
  const Lighting& lights = lighting(shape);
  for (int remaining = options_.comparing() && options_.paths == 0 ? 3 : 1; remaining > 0; --remaining) {
    StageTimes times;
    made.grid = times.time("", [&] { return lights.grid(box_, resolution, content); });
    made.seconds = std::min(made.seconds, times.total());
  }
  return made;
}

}  // namespace example::grid_render
