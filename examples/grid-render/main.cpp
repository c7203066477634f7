// grid-render: many sphere lights by spherical harmonics and their gradients on a 3D grid, beside the same without a
// grid (Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022).
//
// Each point seen gets the light of all spheres in --bands bands, exactly or interpolated, and reflects it by
// convolutions: with the clamped cosine about its normal, and with each glossy lobe about the mirrored view direction
// (reflector.hpp). Nothing casts a shadow: as in the paper, there is no visibility.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lighting.hpp"
#include "lights.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "report.hpp"
#include "shared/interrupt.hpp"
#include "shared/primary_hits.hpp"
#include "shared/program.hpp"
#include "shared/progress.hpp"
#include "shared/ray_caster.hpp"
#include "shared/view.hpp"

namespace example::grid_render {
namespace {

constexpr const char* program_name = "grid-render";

/// Values alone at so many vertices take about the memory of values and gradients at `resolution`: four times as many.
glm::ivec3 equal_memory(const glm::ivec3& resolution) {
  return glm::ivec3(glm::round(std::cbrt(4.0f) * glm::vec3(resolution)));
}

Pass pass_on_grid(const std::string& name, zonal::Interpolation method, const glm::ivec3& resolution) {
  return {name, method, GridFacts{resolution, 0, 0.0}, 0.0, {}, {}};
}

Pass pass_without_grid(const std::string& name) { return {name, std::nullopt, std::nullopt, 0.0, {}, {}}; }

std::vector<Pass> passes_of(const Options& options) {
  using zonal::Interpolation;
  if (!options.comparing()) {
    const std::string name = "picture";
    return {options.method ? pass_on_grid(name, *options.method, options.grid) : pass_without_grid(name)};
  }
  return {pass_without_grid("reference"), pass_on_grid("trilinear", Interpolation::trilinear, options.grid),
          pass_on_grid("taylor", Interpolation::taylor, options.grid),
          pass_on_grid("hermite", Interpolation::hermite, options.grid),
          pass_on_grid("trilinear-equal-memory", Interpolation::trilinear, equal_memory(options.grid))};
}

GridContent content_of(zonal::Interpolation method) {
  return zonal::blocks_read(method) == 1 ? GridContent::values : GridContent::values_and_gradients;
}

/// The grids of a run, each made once.
class Grids {
 public:
  /// Of several `builds` of a grid, the fastest counts: the first one also wakes threads and memory.
  Grids(const Lighting& lighting, const Bounds& box, int bands, int builds)
      : lighting_(lighting), box_(box), bands_(bands), builds_(builds) {}

  /// Sets the pass's facts.
  std::unique_ptr<LightField> field(Pass& pass) {
    if (!pass.grid) return lighting_.exact();
    Made& made = get(pass.grid->resolution, content_of(*pass.method));
    pass.grid->seconds = made.seconds;
    pass.grid->bytes = grid_bytes(bands_, made.resolution, made.content);
    return made.grid->interpolated(*pass.method);
  }

 private:
  struct Made {
    glm::ivec3 resolution;
    GridContent content;
    double seconds;
    std::unique_ptr<LightGrid> grid;
  };

  Made& get(const glm::ivec3& resolution, GridContent content) {
    for (Made& made : made_) {
      if (made.resolution == resolution && made.content == content) return made;
    }
    Made made{resolution, content, std::numeric_limits<double>::infinity(), nullptr};
    for (int build = 0; build < builds_; ++build) {
      StageTimes times;
      made.grid = times.time("", [&] { return lighting_.grid(box_, resolution, content); });
      made.seconds = std::min(made.seconds, times.total());
    }
    return made_.emplace_back(std::move(made));
  }

  const Lighting& lighting_;
  Bounds box_;
  int bands_;
  int builds_;
  std::vector<Made> made_;
};

/// Rough cost of a primary sample, for the time left.
double cost_of(const Pass& pass, std::size_t lights) { return pass.grid ? 1.0 : 0.05 * static_cast<double>(lights); }

/// Fills the passes' pictures.
class PictureRenderer {
 public:
  PictureRenderer(const Scene& scene, const RayCaster& caster, const SphereLights& lights, Report& report)
      : scene_(scene), caster_(caster), report_(report), progress_(!report.options.quiet) {
    const Options& options = report.options;
    reflectors_ = report.times.time(stage_name::materials, [&] { return project_materials(scene.materials, options); });
    lighting_ = make_lighting(lights, options.bands);
    grids_.emplace(*lighting_, report.box, options.bands, options.comparing() ? 3 : 1);
    for (Pass& pass : report.passes) {
      pass.picture = Image(options.width, options.height);
      fields_.push_back(grids_->field(pass));
    }
  }

  void render() {
    const Options& options = report_.options;
    double cost = primary_cost;
    for (const Pass& pass : report_.passes) cost += cost_of(pass, report_.counts.lights);
    progress_.expect(cost * static_cast<double>(report_.counts.primary_samples));
    for_each_slice(options.width, options.height, options.antialias, [this](Slice slice) { render(slice); });
  }

 private:
  static constexpr double primary_cost = 1.0;

  Stage stage(const char* label, double cost) {
    const int antialias = report_.options.antialias;
    return {progress_, label, cost * antialias * antialias};
  }

  void render(Slice slice) {
    const Image& image = report_.passes.front().picture;
    const PrimaryHits hits = report_.times.time(stage_name::primary, [&] {
      return trace_primary(caster_, scene_.camera, image, slice, report_.options.antialias,
                           stage(stage_name::primary, primary_cost));
    });
    report_.counts.primary_hits += hits.count();
    for (std::size_t i = 0; i < fields_.size(); ++i) shade(report_.passes[i], *fields_[i], hits);
  }

  void shade(Pass& pass, const LightField& field, const PrimaryHits& hits) {
    const auto radiance = [&](const Hit& hit, std::size_t) {
      return field.reflected(hit, towards_camera(scene_, hit), reflectors_[hit.material]);
    };
    StageTimes times;
    times.time(pass.name, [&] {
      add_radiance(pass.picture, hits, stage(pass.name.c_str(), cost_of(pass, report_.counts.lights)), radiance);
    });
    pass.seconds += times.total();
  }

  const Scene& scene_;
  const RayCaster& caster_;
  Report& report_;
  Progress progress_;
  std::vector<Reflector> reflectors_;
  std::unique_ptr<Lighting> lighting_;
  std::optional<Grids> grids_;
  std::vector<std::unique_ptr<LightField>> fields_;
};

void finish(Report& report) {
  std::vector<Image*> pictures;
  for (Pass& pass : report.passes) pictures.push_back(&pass.picture);
  report.counts.pixels_not_finite = repair(program_name, pictures);
  const Pass& reference = report.passes.front();
  for (Pass& pass : report.passes) {
    if (&pass != &reference) pass.errors = compare(pass.picture, reference.picture, report.options.display);
  }
}

Scene load_scene(const Options& options) {
  Scene scene = open_scene(options);
  print_warnings(program_name, scene);
  apply(options.camera, scene.camera);
  return scene;
}

/// A flat scene has a box too.
Bounds grid_box(const Bounds& bounds) {
  const glm::vec3 margin = glm::vec3(1e-3f * bounds.radius());
  return {bounds.lower - margin, bounds.upper + margin};
}

void run(const Options& options) {
  Report report;
  report.options = options;
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();
  report.passes = passes_of(options);

  // All that can be wrong with the input comes to light before the work begins.
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  const SphereLights lights = report.times.time(stage_name::lights, [&] { return make_lights(scene, options); });
  const Outputs outputs(options, report.passes);

  const RayCaster caster = report.times.time(stage_name::scene, [&] { return RayCaster(scene); });
  report.box = grid_box(bounds_of(scene.mesh));
  const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  report.counts = {scene.mesh.triangles.size(),
                   scene.materials.size(),
                   lights.size(),
                   pixels * static_cast<std::size_t>(options.antialias * options.antialias),
                   0,
                   0};
  PictureRenderer(scene, caster, lights, report).render();
  finish(report);
  throw_if_interrupted();
  outputs.write(report);
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::grid_render

int main(int argc, char** argv) {
  using namespace example::grid_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
