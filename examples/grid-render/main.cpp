// grid-render: many sphere or triangle lights by spherical harmonics and their gradients on a 3D grid, beside the same
// without a grid (Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2),
// 2022).
//
// Each point seen gets the light of all lights in --bands bands, exactly or interpolated, and reflects it by
// convolutions: with the clamped cosine about its normal, and with each glossy lobe about the mirrored view direction
// (reflector.hpp). Nothing casts a shadow: as in the paper, there is no visibility.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fields.hpp"
#include "lighting.hpp"
#include "lights.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "passes.hpp"
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

/// Rough cost of a primary sample, for the time left.
double cost_of(const Pass& pass) {
  const double cost_of_light = pass.technique.shape == Shape::triangles ? 0.25 : 0.05;
  return pass.grid ? 1.0 : cost_of_light * static_cast<double>(pass.lights);
}

/// Fills the passes' pictures.
class PictureRenderer {
 public:
  PictureRenderer(const Scene& scene, const RayCaster& caster, Fields& fields, Report& report)
      : scene_(scene), caster_(caster), report_(report), progress_(!report.options.quiet) {
    const Options& options = report.options;
    reflectors_ = report.times.time(stage_name::materials, [&] { return project_materials(scene.materials, options); });
    for (Pass& pass : report.passes) {
      pass.picture = Image(options.width, options.height);
      fields_.push_back(fields.field(pass));
    }
  }

  void render() {
    const Options& options = report_.options;
    double cost = primary_cost;
    for (const Pass& pass : report_.passes) cost += cost_of(pass);
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
      return scene_.materials[hit.material].emission +
             field.reflected(hit, towards_camera(scene_, hit), reflectors_[hit.material]);
    };
    StageTimes times;
    times.time(pass.name, [&] { add_radiance(pass.picture, hits, stage(pass.name.c_str(), cost_of(pass)), radiance); });
    pass.seconds += times.total();
  }

  const Scene& scene_;
  const RayCaster& caster_;
  Report& report_;
  Progress progress_;
  std::vector<Reflector> reflectors_;
  std::vector<std::unique_ptr<LightField>> fields_;
};

void finish(Report& report) {
  std::vector<Image*> pictures;
  for (Pass& pass : report.passes) pictures.push_back(&pass.picture);
  report.counts.pixels_not_finite = repair(program_name, pictures);
  warn_if_black(program_name, report.passes.front().picture, report.counts.primary_hits);
  for (Comparison& comparison : report.comparisons) {
    const Image& reference = report.passes[comparison.reference].picture;
    comparison.errors = compare(report.passes[comparison.picture].picture, reference, report.options.display);
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
  report.comparisons = comparisons_of(options, report.passes);

  // All that can be wrong with the input comes to light before the work begins.
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  report.box = grid_box(bounds_of(scene.mesh));
  std::unique_ptr<LightGrid> loaded;
  SphereLights lights;
  report.times.time(stage_name::lights, [&] {
    if (options.load_grid.empty()) {
      lights = make_lights(scene, options);
    } else {
      loaded = load_light_grid(options.load_grid, report.box, options.bands);
      report.passes.front().grid->resolution = report.options.grid = loaded->resolution();
    }
  });
  const Outputs outputs(report, scene);

  const RayCaster caster = report.times.time(stage_name::scene, [&] { return RayCaster(scene); });
  const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  report.counts = {scene.mesh.triangles.size(),
                   scene.materials.size(),
                   lights.size(),
                   pixels * static_cast<std::size_t>(options.antialias * options.antialias),
                   0,
                   0};
  Fields fields(scene, lights, report, std::move(loaded));
  PictureRenderer(scene, caster, fields, report).render();
  finish(report);
  throw_if_interrupted();
  outputs.write(report, fields.first_grid());
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::grid_render

int main(int argc, char** argv) {
  using namespace example::grid_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
