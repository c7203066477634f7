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

/// All that the options ask for.
void render(const Scene& scene, const RayCaster& caster, const Probe* probe, Report& report) {
  const Options& options = report.options;
  Progress progress(!options.quiet);
  const ScreenScene screen = make_screen(scene, caster, options, probe, report.times, progress);
  report.counts.primary_samples = screen.hits.pixel_count();
  report.counts.primary_hits = screen.hits.count();
  report.counts.surface_bytes = screen.surfaces.bytes();
  for (const zonal::LightSet& set : screen.sets) report.counts.lights += static_cast<std::size_t>(set.size());

  const std::vector<Filter> filters = filters_of(options);
  progress.expect(static_cast<double>(filters.size()) * pass_cost(screen) +
                  (options.comparing() ? reference_cost(screen) : 0.0));
  for (const Filter filter : filters) report.passes.push_back(filtered_pass(screen, filter, progress));
  if (options.comparing()) report.reference = reference_pass(screen, progress);
}

/// Mends what is no number, warns of what may be amiss, and compares.
void finish(Report& report) {
  std::vector<Image*> pictures;
  for (Pass& pass : report.passes) pictures.push_back(&pass.picture);
  if (report.reference) {
    pictures.push_back(&report.reference->exact.picture);
    pictures.push_back(&report.reference->truncated.picture);
  }
  report.counts.pixels_not_finite = repair(program_name, pictures);
  const bool black = warn_if_black(program_name, report.passes.front().picture, report.counts.primary_hits);
  if (!black && report.counts.lights == 0) warn(program_name, "there are no lights");
  if (!report.reference) return;
  const Image& exact = report.reference->exact.picture;
  for (Pass& pass : report.passes) pass.errors = compare(pass.picture, exact, report.options.display);
  report.reference->truncated.errors = compare(report.reference->truncated.picture, exact, report.options.display);
}

void write(const Outputs& outputs, const Report& report) {
  std::vector<const Image*> pictures;
  std::vector<Image> differences;
  for (const Pass& pass : report.passes) {
    pictures.push_back(&pass.picture);
    if (report.reference) {
      differences.push_back(difference_map(pass.picture, report.reference->exact.picture, report.options.display));
    }
  }
  if (report.reference) pictures.push_back(&report.reference->exact.picture);
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

  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  render(scene, caster, probe ? &*probe : nullptr, report);
  finish(report);
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
