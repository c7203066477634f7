// hvl-render: one-bounce global illumination by virtual lights of five kinds, beside a path-traced reference.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "direct_light.hpp"
#include "gatherer.hpp"
#include "lit_scene.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "path.hpp"
#include "report.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/primary_hits.hpp"
#include "shared/program.hpp"
#include "shared/progress.hpp"
#include "time_budget.hpp"
#include "virtual_lights.hpp"

namespace example::hvl_render {
namespace {

constexpr const char* program_name = "hvl-render";

std::optional<Image> load_reference(const Options& options) {
  if (options.reference.empty()) return std::nullopt;
  const auto size = [](int width, int height) { return std::to_string(width) + "x" + std::to_string(height); };
  Image reference = read_exr(options.reference);
  if (reference.width != options.width || reference.height != options.height) {
    throw InputError(options.reference + ": is " + size(reference.width, reference.height) + ", not " +
                     size(options.width, options.height));
  }
  return reference;
}

/// All that rendering needs, made once.
struct Renderers {
  const Scene& scene;
  const RayCaster& caster;
  MaterialTables tables;
  VirtualLightMap map;
  std::unique_ptr<Gatherer> gatherer;  // null: no virtual lights
  std::optional<PathTracer> paths;
};

void prepare_lights(Renderers& renderers, Report& report) {
  Options& options = report.options;
  renderers.tables =
      report.times.time(stage_name::materials, [&] { return project_materials(renderers.scene.materials, options); });
  report.material_error = renderers.tables.error;
  throw_if_interrupted();
  if (options.time_budget) {
    report.times.time(stage_name::budget, [&] {
      options.lights = lights_within_budget(renderers.scene, renderers.caster, renderers.tables, options);
    });
  }
  report.times.time(stage_name::lights, [&] {
    renderers.map = shoot_virtual_lights(renderers.scene, renderers.caster, renderers.tables, options);
    renderers.gatherer = make_gatherer({renderers.scene, renderers.caster, renderers.tables, renderers.map, options});
  });
  report.counts.map_lights = renderers.map.lights.size();
  report.counts.virtual_lights =
      static_cast<std::size_t>(std::count_if(renderers.map.lights.begin(), renderers.map.lights.end(), is_lit));
}

void prepare_paths(Renderers& renderers, Report& report) {
  const Options& options = report.options;
  const PathSettings settings{options.samples_per_pixel, options.bounces, options.seed};
  renderers.paths.emplace(renderers.scene, renderers.caster, settings, options.antialias);
  report.counts.samples_per_pixel = renderers.paths->samples_per_pixel();
}

/// Rough costs of a primary sample in rays, for the time left.
struct Costs {
  Costs(const Options& options, const Counts& counts) {
    const double paths_per_sample =
        static_cast<double>(counts.samples_per_pixel) / (options.antialias * options.antialias);
    const double rays_per_light = options.centre_visibility ? 1.0 : options.method == Method::vsl ? 0.5 : 0.1;
    gather = rays_per_light * static_cast<double>(counts.virtual_lights);
    paths = (3.0 + options.bounces) * paths_per_sample;
  }

  double sum() const { return primary + direct + gather + paths; }

  double primary = 1.0;
  double direct = 1.0;
  double gather;
  double paths;
};

/// Renders a slice of the pictures, stage by stage.
class SliceRenderer {
 public:
  SliceRenderer(const Renderers& renderers, Pictures& pictures, Report& report, Progress& progress)
      : renderers_(renderers),
        pictures_(pictures),
        report_(report),
        progress_(progress),
        costs_(report.options, report.counts) {}

  void render(Slice slice) {
    Image& first = renderers_.gatherer ? pictures_.lights : pictures_.path;
    const PrimaryHits hits = trace_primary_rays(slice, first);
    report_.counts.primary_hits += hits.count();
    add_direct_light(first, hits);
    if (report_.options.comparing()) share_direct_light(hits);
    if (renderers_.gatherer) gather(hits);
    if (renderers_.paths) trace_paths(hits);
  }

 private:
  Stage stage(const char* label, double cost) {
    const int antialias = report_.options.antialias;
    return {progress_, label, cost * antialias * antialias};
  }

  PrimaryHits trace_primary_rays(Slice slice, const Image& image) {
    return report_.times.time(stage_name::primary, [&] {
      return trace_primary(renderers_.caster, renderers_.scene.camera, image, slice, report_.options.antialias,
                           stage(stage_name::primary, costs_.primary));
    });
  }

  void add_direct_light(Image& image, const PrimaryHits& hits) {
    const auto radiance = [&](const Hit& hit, std::size_t) {
      return renderers_.scene.materials[hit.material].emission +
             direct_radiance(renderers_.scene, renderers_.caster, hit, towards_camera(renderers_.scene, hit));
    };
    report_.times.time(stage_name::direct,
                       [&] { add_radiance(image, hits, stage(stage_name::direct, costs_.direct), radiance); });
  }

  void share_direct_light(const PrimaryHits& hits) {
    const auto begin = static_cast<std::ptrdiff_t>(pictures_.lights.index(0, hits.slice().first_row));
    const auto count = static_cast<std::ptrdiff_t>(hits.pixel_count());
    std::copy_n(pictures_.lights.pixels.begin() + begin, count, pictures_.path.pixels.begin() + begin);
  }

  void gather(const PrimaryHits& hits) {
    const auto radiance = [&](const Hit& hit, std::size_t sample) {
      return renderers_.gatherer->indirect_radiance(hit, towards_camera(renderers_.scene, hit), sample);
    };
    report_.times.time(stage_name::gather, [&] {
      add_radiance(pictures_.lights, hits, stage(stage_name::gather, costs_.gather), radiance);
    });
  }

  void trace_paths(const PrimaryHits& hits) {
    const auto radiance = [&](const Hit& hit, std::size_t sample) {
      return renderers_.paths->indirect_radiance(hit, sample);
    };
    report_.times.time(stage_name::paths,
                       [&] { add_radiance(pictures_.path, hits, stage(stage_name::paths, costs_.paths), radiance); });
  }

  const Renderers& renderers_;
  Pictures& pictures_;
  Report& report_;
  Progress& progress_;
  Costs costs_;
};

Pictures render(const Renderers& renderers, Report& report) {
  const Options& options = report.options;
  const Image blank(options.width, options.height);
  Pictures pictures{renderers.gatherer ? blank : Image(), renderers.paths ? blank : Image()};
  report.counts.primary_samples = blank.pixels.size() * static_cast<std::size_t>(options.antialias * options.antialias);

  Progress progress(!options.quiet);
  progress.expect(Costs(options, report.counts).sum() * static_cast<double>(report.counts.primary_samples));
  SliceRenderer renderer(renderers, pictures, report, progress);
  for_each_slice(options.width, options.height, options.antialias, [&](Slice slice) { renderer.render(slice); });
  return pictures;
}

void run(const Options& options) {
  Report report;
  report.options = options;
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();

  // All that can be wrong with the input comes to light before the work begins.
  const std::optional<Image> reference = load_reference(options);
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  const Outputs outputs(options, scene);

  const auto caster = report.times.time(stage_name::scene, [&] { return std::make_unique<RayCaster>(scene); });
  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  Renderers renderers{scene, *caster, MaterialTables(), VirtualLightMap(), nullptr, std::nullopt};
  if (options.needs_lights()) prepare_lights(renderers, report);
  if (options.needs_paths()) prepare_paths(renderers, report);

  Pictures pictures = render(renderers, report);
  report.counts.pixels_not_finite = repair(program_name, {&pictures.lights, &pictures.path});
  const bool black =
      warn_if_black(program_name, renderers.gatherer ? pictures.lights : pictures.path, report.counts.primary_hits);
  if (!black && renderers.gatherer && report.counts.virtual_lights == 0) {
    warn(program_name, "the light falls on nothing: there are no virtual lights");
  }
  if (options.comparing()) report.errors = compare(pictures.lights, pictures.path, options.display);
  if (reference)
    report.errors = compare(renderers.gatherer ? pictures.lights : pictures.path, *reference, options.display);
  throw_if_interrupted();
  outputs.write(pictures, report);
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::hvl_render

int main(int argc, char** argv) {
  using namespace example::hvl_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
