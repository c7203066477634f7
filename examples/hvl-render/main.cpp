// hvl-render: one-bounce global illumination by Harmonics Virtual Lights, beside a path-traced reference.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <tbb/global_control.h>
#include <tbb/info.h>

#include "gather_hvl.hpp"
#include "image_file.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "path.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "report.hpp"
#include "view.hpp"
#include "virtual_lights.hpp"

namespace hvl_render {
namespace {

namespace fs = std::filesystem;

constexpr int exit_bad_input = 2;
constexpr int exit_interrupted = 130;
constexpr float difference_full_scale = 0.25f;  // the heat map shows differences four times amplified

/// Linear radiance; an image that no one asked for is empty.
struct Pictures {
  Image hvl;
  Image path;
};

/// Where the pictures and the report go; empty where there is none.
struct Outputs {
  explicit Outputs(const Options& options)
      : picture(options.comparing() ? fs::path() : fs::path(options.out)), report(options.report) {
    if (!options.comparing()) return;
    directory.emplace(options.compare_directory);
    const fs::path folder(options.compare_directory);
    hvl = folder / "hvl";
    reference = folder / "reference";
    difference = folder / "difference.png";
  }

  fs::path picture;
  fs::path report;
  fs::path hvl, reference;  // without their extensions
  fs::path difference;
  std::optional<OutputDirectory> directory;
};

fs::path with_extension(fs::path path, const char* extension) {
  return path += extension;
}

void check_outputs(const Outputs& outputs) {
  if (!outputs.report.empty()) check_writable(outputs.report);
  if (!outputs.picture.empty()) check_writable(outputs.picture);
  if (!outputs.directory) return;
  check_writable(outputs.difference);
  for (const char* extension : {".png", ".exr"}) {
    check_writable(with_extension(outputs.hvl, extension));
    check_writable(with_extension(outputs.reference, extension));
  }
}

std::optional<Image> load_reference(const Options& options) {
  if (options.reference.empty()) return std::nullopt;
  const auto size = [](int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
  };
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
  renderers.tables = report.times.time(stage_name::materials,
                                       [&] { return project_materials(renderers.scene.materials, options); });
  report.material_error = renderers.tables.error;
  throw_if_interrupted();
  report.times.time(stage_name::lights, [&] {
    const auto lights =
        shoot_virtual_lights(renderers.scene, renderers.caster, renderers.tables.emitting, options);
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

void render_slice(const Renderers& renderers, Slice slice, Pictures& pictures, Report& report,
                  Progress& progress) {
  const Options& options = report.options;
  const Scene& scene = renderers.scene;
  const Costs costs(options, report.counts);
  const auto stage = [&](const char* label, double cost) {
    return Stage{progress, label, cost * options.antialias * options.antialias};
  };
  Image& first = renderers.gatherer ? pictures.hvl : pictures.path;

  const PrimaryHits hits = report.times.time(stage_name::primary, [&] {
    return trace_primary(renderers.caster, scene.camera, first, slice, options.antialias,
                         stage(stage_name::primary, costs.primary));
  });
  report.counts.primary_hits += hits.count();
  report.times.time(stage_name::direct, [&] {
    add_radiance(first, hits, stage(stage_name::direct, costs.direct), [&](const Hit& hit, std::size_t) {
      return direct_radiance(scene, renderers.caster, hit, towards_camera(scene, hit));
    });
  });
  if (options.comparing()) {
    const auto begin = static_cast<std::ptrdiff_t>(first.index(0, slice.first_row));
    const auto count = static_cast<std::ptrdiff_t>(hits.pixel_count());
    std::copy_n(pictures.hvl.pixels.begin() + begin, count, pictures.path.pixels.begin() + begin);
  }
  if (renderers.gatherer) {
    report.times.time(stage_name::gather, [&] {
      add_radiance(pictures.hvl, hits, stage(stage_name::gather, costs.gather),
                   [&](const Hit& hit, std::size_t) {
                     return renderers.gatherer->indirect_radiance(hit, towards_camera(scene, hit),
                                                                  renderers.tables.receiving[hit.material]);
                   });
    });
  }
  if (renderers.paths) {
    report.times.time(stage_name::paths, [&] {
      add_radiance(pictures.path, hits, stage(stage_name::paths, costs.paths),
                   [&](const Hit& hit, std::size_t sample) {
                     return renderers.paths->indirect_radiance(hit, sample);
                   });
    });
  }
}

Pictures render(const Renderers& renderers, Report& report) {
  const Options& options = report.options;
  // Some 60 bytes per primary sample: a slice of a million is enough for many threads and little to hold.
  constexpr int samples_per_slice = 1 << 20;
  const int samples_per_row = options.width * options.antialias * options.antialias;
  const int rows_per_slice = std::max(1, samples_per_slice / samples_per_row);
  const Image blank(options.width, options.height);
  Pictures pictures{renderers.gatherer ? blank : Image(), renderers.paths ? blank : Image()};
  report.counts.primary_samples =
      static_cast<std::size_t>(samples_per_row) * static_cast<std::size_t>(options.height);

  Progress progress(!options.quiet);
  progress.expect(Costs(options, report.counts).sum() * static_cast<double>(report.counts.primary_samples));
  for (int row = 0; row < options.height; row += rows_per_slice) {
    const Slice slice{row, std::min(rows_per_slice, options.height - row)};
    render_slice(renderers, slice, pictures, report, progress);
  }
  return pictures;
}

void write_picture(const fs::path& path, const Image& radiance, const Display& display) {
  write_in_place(path, [&](const fs::path& temporary) {
    if (path.extension() == ".exr") {
      write_exr(temporary, radiance);
    } else {
      write_png(temporary, encode(radiance, display));
    }
  });
}

void write_report(const fs::path& path, const Report& report) {
  write_in_place(path, [&](const fs::path& temporary) {
    std::ofstream file(temporary);
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file << json_text(report) << std::flush;
  });
}

void write_outputs(const Outputs& outputs, const Pictures& pictures, const Report& report) {
  const Display& display = report.options.display;
  if (!outputs.picture.empty())
    write_picture(outputs.picture, pictures.hvl.width > 0 ? pictures.hvl : pictures.path, display);
  if (outputs.directory) {
    for (const char* extension : {".png", ".exr"}) {
      write_picture(with_extension(outputs.hvl, extension), pictures.hvl, display);
      write_picture(with_extension(outputs.reference, extension), pictures.path, display);
    }
    const Image difference = difference_map(pictures.hvl, pictures.path, display, difference_full_scale);
    write_in_place(outputs.difference, [&](const fs::path& temporary) { write_png(temporary, difference); });
  }
  if (!outputs.report.empty()) write_report(outputs.report, report);
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
  report.difference_full_scale = static_cast<double>(difference_full_scale);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(report.threads));

  // All that can be wrong with the input comes to light before the work begins.
  const std::optional<Image> reference = load_reference(options);
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  const Outputs outputs(options);
  check_outputs(outputs);

  const auto caster =
      report.times.time(stage_name::scene, [&] { return std::make_unique<RayCaster>(scene); });
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
  write_outputs(outputs, pictures, report);
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
    return exit_interrupted;
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

int main(int argc, char** argv) {
  return hvl_render::run_main(argc, argv);
}
