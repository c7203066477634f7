#pragma once

#include <map>
#include <memory>
#include <vector>

#include "lighting.hpp"
#include "lights.hpp"
#include "report.hpp"
#include "shared/scene.hpp"

namespace example::grid_render {

/// The light of a run's passes: every shape and every grid is made once. All but `loaded` must outlive it.
class Fields {
 public:
  /// `loaded` stands for all grids, if it is there.
  Fields(const Scene& scene, const RayCaster& caster, const SphereLights& lights, const Report& report,
         std::unique_ptr<LightGrid> loaded);

  /// Sets the pass's facts. The field must not outlive this.
  std::unique_ptr<LightField> field(Pass& pass);

  /// The first that was made or loaded; null where there was none.
  const LightGrid* first_grid() const { return made_.empty() ? nullptr : made_.front().grid.get(); }

 private:
  struct Made {
    Shape shape;
    glm::ivec3 resolution;
    GridContent content;
    double seconds;
    std::unique_ptr<LightGrid> grid;
  };

  const Lighting& lighting(Shape shape);
  GridContent content_of(zonal::Interpolation method) const;
  const Made& grid(const Pass& pass);
  Made build(Shape shape, const glm::ivec3& resolution, GridContent content);

  const Scene& scene_;
  const RayCaster& caster_;
  const SphereLights& lights_;
  const Options& options_;
  Bounds box_;
  std::map<Shape, std::unique_ptr<Lighting>> lightings_;
  std::vector<Made> made_;
};

}  // namespace example::grid_render
