// hvl-render: one-bounce global illumination by virtual lights of six kinds, beside a path-traced reference.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "direct_light.hpp"
#include "gatherer.hpp"
#include "lit_scene.hpp"
#include "option_names.hpp"
#include "options.hpp"
#include "path.hpp"
#include "planned_gather.hpp"
#include "report.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/layers.hpp"
#include "shared/outputs.hpp"
#include "shared/program.hpp"
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
  std::unique_ptr<Gatherer> gatherer;  // null: no virtual lights, or a plan
  std::unique_ptr<PlannedGatherer> planned;
  std::optional<PathTracer> paths;
};

void warn_of_glossy_reliefs(const Scene& scene, const MaterialTables& tables) {
  for (const auto& [material, parts] : tables.parts) {
    if (!scene.materials[material].relief || parts.rest.lobes.empty()) continue;
    warn(program_name,
         "virtual lights on '" + scene.materials[material].name +
             "' and other glossy reliefs send their glossy light as if the surface lay as the relief does");
    return;
  }
}

void prepare_lights(Renderers& renderers, Report& report) {
  Options& options = report.options;
  renderers.tables =
      report.times.time(stage_name::materials, [&] { return project_materials(renderers.scene.materials, options); });
  report.material_error = renderers.tables.error;
  warn_of_glossy_reliefs(renderers.scene, renderers.tables);
  throw_if_interrupted();
  if (options.time_budget) {
    report.times.time(stage_name::budget, [&] {
      options.lights = lights_within_budget(renderers.scene, renderers.caster, renderers.tables, options);
    });
  }
  report.times.time(stage_name::lights, [&] {
    renderers.map = shoot_virtual_lights(renderers.scene, renderers.caster, renderers.tables, options);
    const GatherInput input{renderers.scene, renderers.caster, renderers.tables, renderers.map, options};
    if (options.is_planned()) {
      report.scene_plan = report.times.time(stage_name::plan, [&] { return plan_scene(renderers.tables, options); });
      report.table_bytes = keep_planned(renderers.tables, *report.scene_plan);
      renderers.planned = make_planned(input, *report.scene_plan);
      report.light_bytes = renderers.planned->bytes();
    } else {
      renderers.gatherer = make_gatherer(input);
    }
  });
  for (const Material& material : renderers.scene.materials) report.material_names.push_back(material.name);
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

/// Linear radiance; an image that no one asked for is empty.
struct Pictures {
  Image lights;  // by virtual lights
  Image path;

  Image& first() { return lights.width > 0 ? lights : path; }
};

/// Rough costs of a primary sample in rays, for the time left.
double gather_cost(const Report& report) {
  const Options& options = report.options;
  const double rays_per_light = options.centre_visibility ? 1.0 : options.method == Method::vsl ? 0.5 : 0.1;
  return rays_per_light * static_cast<double>(report.counts.virtual_lights);
}
double path_cost(const Report& report) {
  const int positions = report.options.antialias * report.options.antialias;
  return (3.0 + report.options.bounces) * report.counts.samples_per_pixel / positions;
}

/// Emission and direct light, which the pictures of a comparison have in common.
Layer direct_layer(const Scene& scene, const RayCaster& caster, Pictures& pictures) {
  const auto radiance = [&](const Hit& hit, std::size_t) {
    return scene.materials[hit.material].emission + direct_radiance(scene, caster, hit, towards_camera(scene, hit));
  };
  return {stage_name::direct, 1.0, [radiance, &pictures](const PrimaryHits& hits, const Stage& stage) {
            Image& first = pictures.first();
            add_radiance(first, hits, stage, radiance);
            if (&first == &pictures.path || pictures.path.width == 0) return;
            const auto begin = static_cast<std::ptrdiff_t>(first.index(0, hits.slice().first_row));
            const auto count = static_cast<std::ptrdiff_t>(hits.pixel_count());
            std::copy_n(first.pixels.begin() + begin, count, pictures.path.pixels.begin() + begin);
          }};
}

Pictures render(const Renderers& renderers, Report& report) {
  const Scene& scene = renderers.scene;
  const Image blank(report.options.width, report.options.height);
  Pictures pictures{renderers.gatherer || renderers.planned ? blank : Image(), renderers.paths ? blank : Image()};
  std::vector<Layer> layers{direct_layer(scene, renderers.caster, pictures)};
  if (renderers.gatherer) {
    const auto radiance = [&](const Hit& hit, std::size_t sample) {
      return renderers.gatherer->indirect_radiance(hit, towards_camera(scene, hit), sample);
    };
    layers.push_back(layer(stage_name::gather, gather_cost(report), pictures.lights, radiance));
  }
  if (renderers.planned) {
    layers.push_back({stage_name::gather, gather_cost(report), [&](const PrimaryHits& hits, const Stage& stage) {
                        renderers.planned->add(pictures.lights, hits, stage);
                      }});
  }
  if (renderers.paths) {
    const auto radiance = [&](const Hit& hit, std::size_t sample) {
      return renderers.paths->indirect_radiance(hit, sample);
    };
    layers.push_back(layer(stage_name::paths, path_cost(report), pictures.path, radiance));
  }
  report.counts.primary_samples = primary_samples(report.options);
  report.counts.primary_hits = render_layers(scene, renderers.caster, report.options, layers, report.times);
  return pictures;
}

OutputPlan planned_outputs(const Options& options, const Scene& scene) {
  OutputPlan plan{{"picture"}, {}, {}, scene.files};
  if (options.comparing()) plan.pictures = {name_of(method_names, options.method), "reference"};
  if (options.comparing()) plan.differences = {"difference"};
  for (const Material& material : scene.materials) plan.inputs.push_back(material.file);
  plan.inputs.push_back(options.reference);
  return plan;
}

void write(const Outputs& outputs, Pictures& pictures, const Report& report) {
  const std::string text = json_text(report);
  OutputBatch batch;
  if (report.options.comparing()) {
    const Image difference = difference_map(pictures.lights, pictures.path, report.options.display);
    batch = outputs.prepare({&pictures.lights, &pictures.path}, {difference}, text);
  } else {
    batch = outputs.prepare({&pictures.first()}, {}, text);
  }
  batch.move_into_place();
}

void run(const Options& options) {
  Report report;
  report.options = options;
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();

  // All that can be wrong with the input comes to light before the work begins.
  const std::optional<Image> reference = load_reference(options);
  const Scene scene = report.times.time(stage_name::scene, [&] { return load_scene(options); });
  const Outputs outputs(options, planned_outputs(options, scene));

  const auto caster = report.times.time(stage_name::scene, [&] { return std::make_unique<RayCaster>(scene); });
  report.counts.triangles = scene.mesh.triangles.size();
  report.counts.materials = scene.materials.size();
  Renderers renderers{scene, *caster, MaterialTables(), VirtualLightMap(), nullptr, nullptr, std::nullopt};
  if (options.needs_lights()) prepare_lights(renderers, report);
  if (options.needs_paths()) prepare_paths(renderers, report);

  Pictures pictures = render(renderers, report);
  report.counts.pixels_not_finite = repair(program_name, {&pictures.lights, &pictures.path});
  const bool black = warn_if_black(program_name, pictures.first(), report.counts.primary_hits);
  if (!black && options.needs_lights() && report.counts.virtual_lights == 0) {
    warn(program_name, "the light falls on nothing: there are no virtual lights");
  }
  if (options.comparing()) report.errors = compare(pictures.lights, pictures.path, options.display);
  if (reference) report.errors = compare(pictures.first(), *reference, options.display);
  if (renderers.planned) report.plan = renderers.planned->figures();
  throw_if_interrupted();
  write(outputs, pictures, report);
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::hvl_render

int main(int argc, char** argv) {
  using namespace example::hvl_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
