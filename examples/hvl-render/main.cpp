// hvl-render: one-bounce global illumination by Harmonics Virtual Lights, beside a path-traced reference.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/info.h>

#include "gather_hvl.hpp"
#include "image_file.hpp"
#include "input_error.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "path.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "report.hpp"
#include "view.hpp"
#include "virtual_lights.hpp"

namespace hvl_render {
namespace {

constexpr int exit_bad_input = 2;
constexpr int exit_by_signal = 128;  // and the signal's number, as of a shell

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
  std::unique_ptr<Gatherer> gatherer;  // null: no virtual lights
  std::optional<PathTracer> paths;
};

void prepare_lights(Renderers& renderers, Report& report) {
  const Options& options = report.options;
  renderers.tables =
      report.times.time(stage_name::materials, [&] { return project_materials(renderers.scene.materials, options); });
  report.material_error = renderers.tables.error;
  throw_if_interrupted();
  report.times.time(stage_name::lights, [&] {
    const auto lights = shoot_virtual_lights(renderers.scene, renderers.caster, renderers.tables.emitting, options);
    const auto side = static_cast<std::size_t>(map_side(options.lights));
    report.counts.map_lights = side * side;
    report.counts.virtual_lights = lights.size();
    renderers.gatherer = make_gatherer(lights, options);
  });
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
    gather = 0.1 * static_cast<double>(counts.virtual_lights);
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
    Image& first = renderers_.gatherer ? pictures_.hvl : pictures_.path;
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
      return direct_radiance(renderers_.scene, renderers_.caster, hit, towards_camera(renderers_.scene, hit));
    };
    report_.times.time(stage_name::direct,
                       [&] { add_radiance(image, hits, stage(stage_name::direct, costs_.direct), radiance); });
  }

  void share_direct_light(const PrimaryHits& hits) {
    const auto begin = static_cast<std::ptrdiff_t>(pictures_.hvl.index(0, hits.slice().first_row));
    const auto count = static_cast<std::ptrdiff_t>(hits.pixel_count());
    std::copy_n(pictures_.hvl.pixels.begin() + begin, count, pictures_.path.pixels.begin() + begin);
  }

  void gather(const PrimaryHits& hits) {
    const auto radiance = [&](const Hit& hit, std::size_t) {
      return renderers_.gatherer->indirect_radiance(hit, towards_camera(renderers_.scene, hit),
                                                    renderers_.tables.receiving[hit.material]);
    };
    report_.times.time(stage_name::gather,
                       [&] { add_radiance(pictures_.hvl, hits, stage(stage_name::gather, costs_.gather), radiance); });
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
  // Some 60 bytes per primary sample: a slice of a million is enough for many threads and little to hold.
  constexpr int samples_per_slice = 1 << 20;
  const int samples_per_row = options.width * options.antialias * options.antialias;
  const int rows_per_slice = std::max(1, samples_per_slice / samples_per_row);
  const Image blank(options.width, options.height);
  Pictures pictures{renderers.gatherer ? blank : Image(), renderers.paths ? blank : Image()};
  report.counts.primary_samples = static_cast<std::size_t>(samples_per_row) * static_cast<std::size_t>(options.height);

  Progress progress(!options.quiet);
  progress.expect(Costs(options, report.counts).sum() * static_cast<double>(report.counts.primary_samples));
  SliceRenderer renderer(renderers, pictures, report, progress);
  for (int row = 0; row < options.height; row += rows_per_slice) {
    renderer.render({row, std::min(rows_per_slice, options.height - row)});
  }
  return pictures;
}

void count_non_finite(Pictures& pictures, Report& report) {
  report.counts.pixels_not_finite = blacken_non_finite(pictures.hvl) + blacken_non_finite(pictures.path);
  if (report.counts.pixels_not_finite == 0) return;
  std::fprintf(stderr, "hvl-render: warning: %zu pixels are not finite; they are written black\n",
               report.counts.pixels_not_finite);
}

void run(const Options& options) {
  Report report;
  report.options = options;
  report.machine_cores = tbb::info::default_concurrency();
  report.threads = options.threads > 0 ? options.threads : report.machine_cores;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(report.threads));

  // All that can be wrong with the input comes to light before the work begins.
  const std::optional<Image> reference = load_reference(options);
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  const Outputs outputs(options);

  const auto caster = report.times.time(stage_name::scene, [&] { return std::make_unique<RayCaster>(scene); });
  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  Renderers renderers{scene, *caster, MaterialTables(), nullptr, std::nullopt};
  if (options.needs_lights()) prepare_lights(renderers, report);
  if (options.needs_paths()) prepare_paths(renderers, report);

  Pictures pictures = render(renderers, report);
  count_non_finite(pictures, report);
  if (options.comparing()) report.errors = compare(pictures.hvl, pictures.path, options.display);
  if (reference)
    report.errors = compare(renderers.gatherer ? pictures.hvl : pictures.path, *reference, options.display);
  throw_if_interrupted();
  outputs.write(pictures, report);
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

int run_main(int argc, char** argv) {
  try {
    const CommandLine line = parse_command_line(argc, argv);
    if (line.exit_status) return *line.exit_status;
    listen_for_interrupts();
    run(line.options);
    return 0;
  } catch (const Interrupted&) {
    std::fputs("hvl-render: interrupted, nothing written\n", stderr);
    return exit_by_signal + stop_signal();
  } catch (const InputError& error) {
    std::fprintf(stderr, "hvl-render: %s\n", error.what());
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hvl-render: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace hvl_render

int main(int argc, char** argv) { return hvl_render::run_main(argc, argv); }
