// grid-render: many sphere or triangle lights by spherical harmonics and their gradients on a 3D grid, beside the same
// without a grid (Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2),
// 2022).
//
// Each point seen gets the light of all lights in --bands bands, exactly or interpolated, and reflects it by
// convolutions: with the clamped cosine about its normal, and with each glossy lobe about the mirrored view direction
// (reflector.hpp). Nothing casts a shadow, as in the paper; unless the light is found by --paths (paths.hpp), which
// --visibility then keeps from leaking through walls.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <zonal/grid/grid_file.hpp>

#include "fields.hpp"
#include "lighting.hpp"
#include "lights.hpp"
#include "options.hpp"
#include "passes.hpp"
#include "report.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/layers.hpp"
#include "shared/outputs.hpp"
#include "shared/program.hpp"
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

/// Pixels across of the small pictures by which a grid is planned, and its error measured.
constexpr int planning_width = 64, measuring_width = 90;

/// The light of the one pass, by a tolerance.
std::shared_ptr<LightField> planned_field(const PlannedLighting& lighting, const SphereLights& lights,
                                          const std::vector<Reflector>& reflectors, std::vector<SeenHit> hits,
                                          Report& report) {
  Pass& pass = report.passes.front();
  GridPlan plan = report.times.time(stage_name::plan, [&] {
    return plan_grid(lighting, lights, std::move(hits), reflectors, report.box, report.options);
  });
  PlannedField made = lighting.field(report.box, plan.choice);
  plan.near_bytes = made.near_bytes;
  pass.lights = lights.size();
  pass.technique.method = std::nullopt, pass.grid = std::nullopt;
  if (plan.choice.bands > 0) {
    pass.technique.method = plan.choice.method;
    pass.grid =
        GridFacts{plan.choice.resolution, grid_bytes(plan.choice.bands, plan.choice.resolution, plan.choice.content()),
                  made.fill_seconds};
  }
  report.plan = plan;
  return std::move(made.field);
}

/// Fills the passes' pictures.
void render(const Scene& scene, const RayCaster& caster, const SphereLights& lights, Fields& fields, Report& report) {
  const Options& options = report.options;
  const std::vector<Reflector> reflectors =
      report.times.time(stage_name::materials, [&] { return project_materials(scene.materials, options); });
  const auto planned = options.is_planned() ? make_planned_lighting(lights, options.bands) : nullptr;
  std::vector<Layer> layers;
  std::shared_ptr<LightField> field;
  for (Pass& pass : report.passes) {
    pass.picture = Image(options.width, options.height);
    field = planned
                ? planned_field(*planned, lights, reflectors, seen_hits(scene, caster, planning_width, options), report)
                : fields.field(pass);
    layers.push_back(layer(pass.name, cost_of(pass), pass.picture, [&, field](const Hit& hit, std::size_t) {
      return scene.materials[hit.material].emission +
             field->reflected(hit, towards_camera(scene, hit), reflectors[hit.material]);
    }));
  }
  report.counts.primary_samples = primary_samples(options);
  report.counts.primary_hits = render_layers(scene, caster, options, layers, report.times);
  for (Pass& pass : report.passes) pass.seconds = report.times.seconds(pass.name);
  if (planned && options.explain) {
    measure(*report.plan, *planned, *field, seen_hits(scene, caster, measuring_width, options), reflectors,
            report.counts.primary_hits);
  }
}

/// Of the comparisons.
std::vector<Image> differences(const Report& report) {
  std::vector<Image> pictures;
  for (const Comparison& comparison : report.comparisons) {
    pictures.push_back(amplified_difference(report.passes[comparison.picture].picture,
                                            report.passes[comparison.reference].picture, report.options.display,
                                            difference_factor));
  }
  return pictures;
}

OutputPlan planned_outputs(const Report& report, const Scene& scene) {
  const Options& options = report.options;
  OutputPlan plan{{}, {}, {options.save_grid}, scene.files};
  for (const Pass& pass : report.passes) plan.pictures.push_back(pass.name);
  for (const Comparison& comparison : report.comparisons) plan.differences.push_back(comparison.name);
  plan.inputs.insert(plan.inputs.end(), {options.texture, options.load_grid});
  return plan;
}

void save(const LightGrid& grid, const std::string& path) {
  try {
    grid.save(path);
  } catch (const zonal::GridFileError& error) {
    throw InputError(one_line(error.what()));
  }
}

void finish(Report& report) {
  std::vector<Image*> pictures;
  for (Pass& pass : report.passes) pictures.push_back(&pass.picture);
  report.counts.pixels_not_finite = repair(program_name, pictures);
  warn_if_black(program_name, report.passes.front().picture, report.counts.primary_hits);
  for (Comparison& comparison : report.comparisons) {
    const Image& reference = report.passes[comparison.reference].picture;
    comparison.leak = leak(report.passes[comparison.picture].picture, reference);
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
  const Outputs outputs(options, planned_outputs(report, scene));

  const RayCaster caster = report.times.time(stage_name::scene, [&] { return RayCaster(scene); });
  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  report.counts.lights = lights.size();
  Fields fields(scene, caster, lights, report, std::move(loaded));
  render(scene, caster, lights, fields, report);
  finish(report);
  throw_if_interrupted();

  std::vector<const Image*> pictures;
  for (const Pass& pass : report.passes) pictures.push_back(&pass.picture);
  OutputBatch batch = outputs.prepare(pictures, differences(report), json_text(report));
  if (!options.save_grid.empty()) save(*fields.first_grid(), options.save_grid);
  batch.move_into_place();
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::grid_render

int main(int argc, char** argv) {
  using namespace example::grid_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
