// field-render: things that stand in an incident light field, lit by its coefficient grid, beside path tracing of the
// light that is there (Loew et al., HDR light probe sequence resampling for realtime incident light field rendering,
// SCCG 2009, Fig. 9 to 11). As in the paper things neither shadow nor light each other.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grid_light.hpp"
#include "inserted.hpp"
#include "options.hpp"
#include "reference.hpp"
#include "report.hpp"
#include "shared/interrupt.hpp"
#include "shared/layers.hpp"
#include "shared/outputs.hpp"
#include "shared/program.hpp"
#include "shared/view.hpp"

namespace example::field_render {
namespace {

constexpr const char* program_name = "field-render";

/// The scene that the grid was captured in, and its light.
struct Surroundings {
  explicit Surroundings(const Options& options)
      : scene(open_scene(options)),
        emitters(set_up_field(*options.reference, field_box(scene, options.box), scene)),
        caster(scene),
        light(scene, caster, emitters, options.bounces) {
    print_warnings(program_name, scene);
  }

  Scene scene;
  std::vector<Emitter> emitters;
  RayCaster caster;
  IncidentRadiance light;
};

struct Pictures {
  std::optional<Image> grid, reference;

  std::vector<Image*> all() {
    std::vector<Image*> list;
    for (auto* picture : {&grid, &reference}) {
      if (*picture) list.push_back(&**picture);
    }
    return list;
  }
};

Layer grid_layer(const Scene& things, const GridLight& light, const std::vector<SplitMaterial>& materials,
                 const GlossShading& shading, Image& picture) {
  return layer("grid", 0.3, picture, [&, shading](const Hit& hit, std::size_t) {
    return light.reflected(hit, towards_camera(things, hit), materials[hit.material], shading);
  });
}

Layer reference_layer(const Scene& things, const IncidentRadiance& light, const Options& options, Image& picture) {
  const int positions = options.antialias * options.antialias;
  const int count = (options.samples + positions - 1) / positions;
  return layer("reference", 10.0 * count, picture, [&, count](const Hit& hit, std::size_t sample) {
    return true_radiance(light, brdf_at(things, hit), hit, towards_camera(things, hit), count,
                         hash64(options.seed) ^ sample);
  });
}

OutputPlan planned_outputs(const Options& options, const Scene& things, const Surroundings* surroundings) {
  OutputPlan plan{{"picture"}, {}, {}, things.files};
  if (options.comparing()) plan = {{"grid", "reference"}, {"difference"}, {}, things.files};
  plan.inputs.emplace_back(options.grid);
  if (surroundings != nullptr) {
    plan.inputs.insert(plan.inputs.end(), surroundings->scene.files.begin(), surroundings->scene.files.end());
  }
  return plan;
}

void run(const Options& options) {
  Report report;
  report.options = options;
  const ThreadLimit limit(options.threads);
  report.machine = limit.machine();

  // All that can be wrong with the input comes to light before the work begins.
  const std::unique_ptr<GridLight> grid =
      report.times.time("grid file", [&] { return load_grid_light(options.grid, options.interpolation); });
  report.box = grid->box();
  report.resolution = grid->resolution();
  report.grid_bands = grid->bands();
  Scene things = make_inserted(options, report.box);
  print_warnings(program_name, things);
  apply(options.camera, things.camera);
  std::unique_ptr<Surroundings> surroundings;
  if (options.reference) {
    surroundings = report.times.time(stage_name::scene, [&] { return std::make_unique<Surroundings>(options); });
  }
  const Outputs outputs(options, planned_outputs(options, things, surroundings.get()));
  const RayCaster caster(things);

  Pictures pictures;
  std::vector<Layer> layers;
  std::vector<SplitMaterial> materials;
  if (!options.reference || options.comparing()) {
    report.times.time(stage_name::materials, [&] {
      for (const Material& material : things.materials) materials.emplace_back(material);
    });
    pictures.grid.emplace(options.width, options.height);
    layers.push_back(grid_layer(things, *grid, materials, {options.bands, options.window}, *pictures.grid));
  }
  if (surroundings) {
    pictures.reference.emplace(options.width, options.height);
    layers.push_back(reference_layer(things, surroundings->light, options, *pictures.reference));
  }
  report.counts.triangles = things.mesh.triangles.size();
  report.counts.materials = things.materials.size();
  report.counts.primary_samples = primary_samples(options);
  report.counts.primary_hits = render_layers(things, caster, options, layers, report.times);

  const std::vector<Image*> all = pictures.all();
  report.counts.pixels_not_finite = repair(program_name, all);
  warn_if_black(program_name, *all.front(), report.counts.primary_hits);
  std::vector<Image> differences;
  if (options.comparing()) {
    report.errors = compare(*pictures.grid, *pictures.reference, options.display);
    differences.push_back(difference_map(*pictures.grid, *pictures.reference, options.display));
  }
  throw_if_interrupted();
  outputs.prepare({all.begin(), all.end()}, differences, json_text(report)).move_into_place();
  if (!options.quiet) std::fputs(table(report).c_str(), stdout);
}

}  // namespace
}  // namespace example::field_render

int main(int argc, char** argv) {
  using namespace example::field_render;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
