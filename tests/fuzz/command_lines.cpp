// The command line of every program, an argument a line: refused in one line, or options within the ranges that --help
// states.
#include "targets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../../examples/field-bake/options.hpp"
#include "../../examples/field-capture/options.hpp"
#include "../../examples/field-render/options.hpp"
#include "../../examples/grid-render/options.hpp"
#include "../../examples/hvl-render/options.hpp"
#include "../../examples/igi-render/options.hpp"
#include "../../examples/shared/input_error.hpp"
#include "../../examples/shared/material_change.hpp"
#include "../../tools/zonal-glsl/options.hpp"
#include "../../tools/zonal-probe/options.hpp"

namespace fuzz {
namespace {

template <class Number>
bool is_within(Number least, Number x, Number most) {
  return least <= x && x <= most;
}

void check(const example::CommonOptions& o) {
  require(is_within(1, o.width, 16384) && is_within(1, o.height, 16384), "--size");
  require(is_within(1, o.antialias, 16), "--antialias");
  require(is_within(-30.0F, o.display.exposure_stops, 30.0F), "--exposure");
  require(is_within(0, o.threads, 1024), "--threads");
  for (const auto& point : {o.camera.position, o.camera.target}) {
    for (int i = 0; point && i < 3; ++i) require(std::abs((*point)[i]) <= 1e8F, "--camera and --target");
  }
  require(is_within(0.0F, o.camera.vertical_field_of_view.value_or(1.0F), 3.0F), "--fov");
}

/// What a scene with one material makes of --material, but for files.
void change_material(const std::vector<example::MaterialChange>& changes) {
  for (const example::MaterialChange& change : changes) {
    const std::filesystem::path extension = std::filesystem::path(change.spec).extension();
    if (extension == ".binary" || extension == ".bsdf") return;
  }
  std::vector<example::Material> materials(1);
  materials[0].name = "gold";
  example::apply(changes, materials);
}

void check_more(const example::hvl_render::Options& o) {
  using namespace example::hvl_render;
  check(o);
  require(is_within(1, o.lights, most_lights), "--lights");
  require(o.time_budget || is_within(1, map_side(o), most_texels_across), "--vsgl-texels");
  require(is_within(0.001, o.time_budget.value_or(1.0), 1e6), "--time-budget");
  require(is_within(0.0F, o.vpl_clamp, 100.0F) && is_within(1, o.vsl_samples, 1024), "--vpl-clamp and --vsl-samples");
  require(o.radius != RadiusRule::fixed || (o.fixed_radius > 0 && std::isfinite(o.fixed_radius)), "--radius");
  require(is_within(0.01F, o.radius_factor, 100.0F), "--radius-factor");
  require(is_within(0.0, o.tolerance, 1.0) && is_within(0.0F, o.checked_share, 1.0F), "--tolerance and --check");
  require(is_within(1, o.samples_per_pixel, 1000000) && is_within(1, o.bounces, 64), "--spp and --bounces");
  require(is_within(1, o.bands, 21) && is_within(1, o.emission_bands, 5), "--bands");
  change_material(o.materials);
}
void check_more(const example::igi_render::Options& o) {
  check(o);
  require(o.pattern.what_is_wrong(o.width * o.antialias, o.height * o.antialias).empty(), "--pattern");
  require(is_within(2, o.bands, 5) && is_within(1, o.samples, 4096) && is_within(0, o.bounces, 16), "--sets");
  require(is_within(-1.0F, o.tests.cos_normal, 1.0F) && is_within(0.0F, o.tests.plane_distance, 1.0F), "tests");
  require(is_within(0.0F, o.least_distance, 1e6F), "--least-distance");
}
void check_resolution(const glm::ivec3& resolution, int most) {
  for (int i = 0; i < 3; ++i) require(is_within(2, resolution[i], most), "--grid");
}
void check_more(const example::grid_render::Options& o) {
  check(o);
  check_resolution(o.grid, 32);
  require(is_within(1, o.lights, 100000) && is_within(1, o.texture_size, 512), "--lights and --texture-size");
  require(is_within(3, o.bands, 9) && is_within(1, o.lobe_bands, 9), "--bands and --lobe-bands");
  require(is_within(0, o.paths, 65536) && is_within(0.0, o.tolerance, 1.0), "--paths and --tolerance");
  require(is_within(0.0F, o.quadtree_error.value_or(0.0F), 1000.0F), "--quadtree-error");
}
void check_more(const example::field_bake::Options& o) {
  check_resolution(o.resolution, 1024);
  require(is_within(2, o.bands, 6) && is_within(1, o.memory, 1 << 20) && is_within(0, o.threads, 1024), "--memory");
  if (o.thinning) require(is_within(0.0F, o.thinning->difference, 2.0F) && o.thinning->distance >= 0, "--thin");
}
void check_more(const example::field_capture::Options& o) {
  check(o);
  require(is_within(1, o.probes, 1000000) && is_within(8, o.side, 4096), "--probes and --size");
  require(is_within(0.0F, o.sphere_radius.value(), 1.0F) && is_within(0.0F, o.dead_angle, 90.0F), "--dead-angle");
  require(is_within(1, o.samples, 65536) && is_within(0, o.bounces, 16) && is_within(1, o.bands, 9), "--samples");
  require(is_within(16, o.truth_samples, 1 << 24), "--truth-samples");
}
void check_more(const example::field_render::Options& o) {
  check(o);
  require(is_within(1, o.bands, 6) && is_within(1, o.samples, 65536) && is_within(0, o.bounces, 16), "--samples");
  change_material(o.materials);
}

void check_more(const zonal_probe::Options& o) {
  require(is_within(1, o.bands.value_or(1), 10) && is_within(0, o.threads, 1024), "--bands and --threads");
  for (const auto& turn : o.turns) require(is_within(-3600.0, turn.degrees, 3600.0), "--rotate");
  require(!o.window.width || (*o.window.width > 0 && *o.window.width <= 1000), "--window");
  require(o.list || !o.input.empty(), "a picture, or coefficients");
}
/// What the functions that are asked for are, too: a text, or a refusal.
void write_shader(int argc, char** argv) {
  const zonal_glsl::Options options = zonal_glsl::parse_command_line(argc, argv);
  if (!options.exit_status) require(!shader_file(options.request, *options.dialect).empty(), "a text");
}

void parse(int argc, char** argv, const std::function<void(int, char**)>& parser) {
  try {
    parser(argc, argv);
  } catch (const example::InputError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "an error is one line");
  } catch (const zonal_glsl::RequestError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "an error is one line");
  }
}

/// An argument a line; a zero byte ends it, as in argv.
Target program(const std::string& name, const std::function<void(int, char**)>& parser,
               std::vector<std::string> seeds) {
  const auto feed = [name, parser](const std::string& bytes) {
    std::vector<std::string> arguments{name};
    for (std::size_t at = 0, end = 0; at < bytes.size(); at = end + 1) {
      end = std::min(bytes.find('\n', at), bytes.size());
      arguments.push_back(bytes.substr(at, end - at));
    }
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    parse(int(arguments.size()), argv.data(), parser);
  };
  for (std::string& seed : seeds) std::replace(seed.begin(), seed.end(), ' ', '\n');
  return {name, feed, std::move(seeds)};
}

template <class Parse>
Target program(const std::string& name, const Parse& parse_command_line, const std::vector<std::string>& seeds) {
  return program(name, std::function<void(int, char**)>([parse_command_line](int argc, char** argv) {
                   const auto line = parse_command_line(argc, argv);
                   if (!line.exit_status) check_more(line.options);
                 }),
                 seeds);
}

}  // namespace

std::vector<Target> command_lines() {
  using namespace example;
  const std::string common =
      "--size 64x48 --antialias 2 --exposure -1.5 --tone clamp --threads 1 --quiet --scene a.obj --no-stage --up z "
      "--view inside --camera 1,2,3 --target 4,5,-6e-1 --fov 40 --report x.json ";
  return {
      program("hvl-render", hvl_render::parse_command_line,
              {common + "--method vsgl --lights 400 --vsgl-texels 8 --radius 0.5 --radius-factor 2 --spp 3 --seed 7",
               common + "--tolerance 0.01 --check 0.5 --explain --bands 5 --emission-bands 3 --horizon exact",
               "--compare out --material gold=matte:1,1,0.5 --material *=plastic:0.1,0.2,0.3,0.4 --multiple-scattering "
               "--material-cache x --window hann",
               "--method path --bounces 3 --light 1,2,3 --light-target 0,0,0 --light-angle 30 --light-power 100",
               "--time-budget 2 --visibility centre --method vpl --vpl-clamp 2 --reference r.exr --out x.exr --help"}),
      program("igi-render", igi_render::parse_command_line,
              {common + "--pattern 4x4 --bands 3 --window sinc --half --normal-angle-cosine 0.9 --plane-distance 0.1",
               "--filter sg --lighting area --sets 8 --bounces 1 --least-distance 0.1 --seed 3 --out x.png",
               "--compare out --probe p.hdr --version"}),
      program("grid-render", grid_render::parse_command_line,
              {common + "--lights 10 --shape triangles --grid 8x4x4 --bands 5 --lobe-bands 9 --window hann",
               "--texture t.png --texture-size 9 --quadtree-error 0.1 --interpolation taylor --save-grid g",
               "--paths 16 --visibility --out x.png", "--tolerance 0.01 --explain", "--load-grid g", "--compare out",
               "--compare-shapes out"}),
      program("field-bake", field_bake::parse_command_line,
              {"s.txt --grid 8 --box 0,0,0,1,1,1 --bands 5 --gradients --half --estimate mean --repair nearest",
               "--path space s.txt --thin 0.1 --thin-distance 2 --out g --work w --keep-work --memory 64 --report x "
               "--threads 2 --quiet"}),
      program("field-capture", field_capture::parse_command_line,
              {"--setup spots --box 0,0,0,1,1,1 --probes 100 --layout planes --size 64 --mapping mirror-sphere "
               "--sphere-radius 0.1 --dead-angle 3 --dead-angle-is missing --samples 2 --bounces 1 --seed 4",
               "--truth t.txt --bands 5 --truth-samples 100 --out t.csv"}),
      program("field-render", field_render::parse_command_line,
              {common + "--grid g --object table --material *=gold:0.3 --interpolation hermite --bands 4 --window hann",
               "--compare out --grid g --reference spots --box 0,0,0,1,1,1 --samples 4 --bounces 2 --seed 1"}),
      program("zonal-glsl", std::function<void(int, char**)>(write_shader),
              {"--functions evaluate@3,cap:even --bands 5 --dialect glsl450 -o x --prefix zonal_ --precise --flat",
               "--functions evaluate:degree2@3,gather_zonal --bands 2 --dialect hlsl",
               "--adjoint reconstruct --by sh,direction --temporaries --count --plan p.json", "--list --version"}),
      program("zonal-probe", zonal_probe::parse_command_line,
              {"sky.hdr --mapping equirectangular --bands 4 --rotate up:90,right:-20.5 --window hann:3 --format glsl",
               "a.txt --from unity --planes --input-frame unity --quantity irradiance-over-pi --frame x,y,-z --out b "
               "--window auto --window-by luminance --convention three.js --format json --preview p.png --threads 2",
               "sky.png --name probe_1 --window sinc --quiet --list"}),
  };
}

}  // namespace fuzz
