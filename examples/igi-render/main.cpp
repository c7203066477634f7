// igi-render: instant radiosity with interleaved sampling, and what filters make of it, beside all light at every
// pixel.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "option_names.hpp"
#include "options.hpp"
#include "report.hpp"
#include "screen_scene.hpp"
#include "shaded_picture.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/outputs.hpp"
#include "shared/program.hpp"
#include "shared/view.hpp"

namespace example::igi_render {
namespace {

constexpr const char* program_name = "igi-render";

std::vector<Filter> filters_of(const Options& options) {
  if (!options.comparing()) return {options.filter};
  std::vector<Filter> filters;
  for (const auto& [name, filter] : filter_names) filters.push_back(filter);
  return filters;
}

OutputPlan planned_outputs(const Options& options, const Scene& scene) {
  OutputPlan plan{{"picture"}, {}, {}, scene.files};
  if (options.comparing()) {
    plan.pictures.clear();
    for (const auto& [name, filter] : filter_names) {
      plan.pictures.push_back(name);
      plan.differences.push_back(name + "-difference");
    }
    plan.pictures.push_back("reference");
  }
  plan.inputs.push_back(options.probe);
  return plan;
}

ScreenScene make_screen(const Scene& scene, const RayCaster& caster, const Probe* probe, Report& report,
                        Progress& progress) {
  const Options& options = report.options;
  const int width = options.width * options.antialias, height = options.height * options.antialias;
  std::vector<ScreenMaterial> materials;
  report.times.time(stage_name::materials, [&] {
    for (const Material& material : scene.materials) {
      throw_if_interrupted();
      materials.emplace_back(material);
    }
  });
  std::vector<zonal::LightSet> sets =
      report.times.time(stage_name::lights, [&] { return make_light_sets(scene, caster, options, probe); });
  PrimaryHits hits = report.times.time(stage_name::primary, [&] {
    return trace_primary(caster, scene.camera, width, height, {0, height}, 1, {progress, stage_name::primary, 0.0});
  });
  const float radius = bounds_of(scene.mesh).radius();
  const float least_distance = options.least_distance > 0.0f ? options.least_distance : 0.02f * radius;
  zonal::SurfacePicture surfaces = make_surfaces(hits, width, height, false);
  zonal::SurfacePicture shading_surfaces = make_surfaces(hits, width, height, true);
  return {scene,
          caster,
          options,
          probe,
          std::move(materials),
          std::move(sets),
          least_distance,
          2.0f * radius,
          width,
          height,
          std::move(hits),
          std::move(surfaces),
          std::move(shading_surfaces)};
}

/// All light at every position, and the errors of the passes against it.
void compare_with_all(const ScreenScene& screen, Report& report, Progress& progress) {
  Reference reference = reference_pass(screen, progress);
  std::vector<Image*> pictures{&reference.exact.picture, &reference.truncated.picture};
  repair(program_name, pictures);
  const Display& display = report.options.display;
  for (Pass& pass : report.passes) pass.errors = compare(pass.picture, reference.exact.picture, display);
  report.truncation = compare(reference.truncated.picture, reference.exact.picture, display);
  report.reference = std::move(reference.exact);
}

void write(const Outputs& outputs, const Report& report) {
  std::vector<const Image*> pictures;
  std::vector<Image> differences;
  for (const Pass& pass : report.passes) {
    pictures.push_back(&pass.picture);
    if (report.reference) {
      differences.push_back(difference_map(pass.picture, report.reference->picture, report.options.display));
    }
  }
  if (report.reference) pictures.push_back(&report.reference->picture);
  outputs.prepare(pictures, differences, json_text(report)).move_into_place();
}

void run(const Options& options) {
  Report report;
  report.options = options;
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();

  // All that can be wrong with the input comes to light before the work begins.
  std::optional<Probe> probe;
  Scene scene = report.times.time(stage_name::scene, [&] {
    if (options.lighting == Lighting::probe) probe.emplace(options.probe);
    return open_scene(options);
  });
  print_warnings(program_name, scene);
  apply(options.camera, scene.camera);
  const Outputs outputs(options, planned_outputs(options, scene));
  const RayCaster caster = report.times.time(stage_name::scene, [&] { return RayCaster(scene); });

  Progress progress(!options.quiet);
  const ScreenScene screen = make_screen(scene, caster, probe ? &*probe : nullptr, report, progress);
  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  report.counts.primary_samples = screen.hits.pixel_count();
  report.counts.primary_hits = screen.hits.count();
  report.counts.surface_bytes = screen.surfaces.bytes();
  for (const zonal::LightSet& set : screen.sets) report.counts.lights += static_cast<std::size_t>(set.size());
  if (report.counts.lights == 0) warn(program_name, "there are no lights");

  const std::vector<Filter> filters = filters_of(options);
  progress.expect(static_cast<double>(filters.size()) * pass_cost(screen) +
                  (options.comparing() ? reference_cost(screen) : 0.0));
  std::vector<Image*> pictures;
  for (const Filter filter : filters) report.passes.push_back(filtered_pass(screen, filter, progress));
  for (Pass& pass : report.passes) pictures.push_back(&pass.picture);
  report.counts.pixels_not_finite = repair(program_name, pictures);
  warn_if_black(program_name, report.passes.front().picture, report.counts.primary_hits);
  if (options.comparing()) compare_with_all(screen, report, progress);
  throw_if_interrupted();
  write(outputs, report);
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::igi_render

int main(int argc, char** argv) {
  using namespace example::igi_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
