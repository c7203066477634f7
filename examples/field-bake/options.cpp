#include "options.hpp"

#include "shared/command_line.hpp"
#include "shared/input_error.hpp"
#include "shared/names.hpp"

namespace example::field_bake {
namespace {

const std::vector<int> baked_bands{2, 3, 4, 5, 6};  // make_baking has a case for each

enum class Estimate { linear, mean };
const Names<Estimate> estimate_names = {{"linear", Estimate::linear}, {"mean", Estimate::mean}};
const Names<zonal::Repair> repair_names = {{"mip-maps", zonal::Repair::mip_maps}, {"nearest", zonal::Repair::nearest}};
const Names<Path> path_names = {{"plane", Path::plane}, {"space", Path::space}};

void add_grid_options(CLI::App& app, Options& options) {
  const std::string group = "Grid";
  add_resolution_option(app, options.resolution, 1024, "Points along each axis of the box")->group(group);
  add_box_option(app, options.box, "of the grid, in the sequence's unit; without it, of all probes")->group(group);
  add_one_of(app, "--bands", options.bands, baked_bands, "Bands of the coefficients: 3 for diffuse light, 5 for glossy")
      ->group(group);
  app.add_flag("--gradients", options.gradients,
               "Spatial gradients as well, for Hermite interpolation: four times the memory")
      ->group(group);
  app.add_flag("--half", options.half, "Numbers of 16 bits in the file: half as large, rounded to 11 bits")
      ->group(group);
}

void add_resampling_options(CLI::App& app, Options& options, Estimate& estimate) {
  const std::string group = "Resampling";
  add_choice(app, "--estimate", estimate_names, estimate,
             "Between scattered samples: a linear fit, or the weighted mean, as the paper has it")
      ->group(group);
  add_choice(app, "--repair", repair_names, options.resampling.repair, "What points get that no sample reached")
      ->group(group);
  add_choice(app, "--path", path_names, options.path,
             "In the plane across each direction, or through space, as the paper has it: the reference, slow, of means")
      ->group(group);
  const auto thinning = [&options]() -> zonal::Thinning& {
    if (!options.thinning) options.thinning.emplace();
    return *options.thinning;
  };
  CLI::Option* thin =
      add_number_function(
          app, "--thin", [thinning](float difference) { thinning().difference = difference; }, 0.0f, 2.0f, "0...2",
          "Leave out probes that differ by no more than this from the last kept and from the next, as energy of the "
          "difference over the mean energy")
          ->group(group);
  add_number_function(
      app, "--thin-distance", [thinning](float distance) { thinning().distance = distance; }, 0.0f, 1e6f, "0...1e6",
      "Only where both are as near as this, in the sequence's unit")
      ->needs(thin)
      ->group(group);
}

void add_output_options(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "The grid's file")
      ->type_name("FILE")
      ->check(not_empty())
      ->capture_default_str()
      ->group(run_group);
  app.add_option("--work", options.work,
                 "Folder for samples and sums; what is there of the same bake is not made again. Without it the grid's "
                 "name and .work")
      ->type_name("FOLDER")
      ->check(not_empty())
      ->group(run_group);
  app.add_flag("--keep-work", options.keep_work,
               "Leave the folder where it is: another grid of the same samples takes them from there")
      ->group(run_group);
  add_number(app, "--memory", options.memory, 1, 1 << 20, "1...1048576",
             "MiB for pictures' samples on their way to disk")
      ->group(run_group);
  app.add_option("--report", options.report, "Write what was done, and how long it took, as JSON")
      ->type_name("FILE")
      ->check(not_empty())
      ->group(run_group);
  add_number(app, "--threads", options.threads, 0, 1024, "0...1024", "Threads; 0 for all cores")->group(run_group);
  app.add_flag("--quiet", options.quiet, "Print nothing but errors")->group(run_group);
}

}  // namespace

CommandLine<Options> parse_command_line(int argc, char** argv) {
  CommandLine<Options> line;
  Options& options = line.options;
  Estimate estimate = Estimate::linear;
  CLI::App app(
      "Turns a sequence of light probes into a grid of spherical harmonic\n"
      "coefficients: the light of every place in a volume. May be stopped at any\n"
      "moment; the same command goes on from there.",
      "field-bake");
  set_up(app);
  app.add_option("sequence", options.sequence, "Text file of pictures and positions")->type_name("FILE")->required();
  add_grid_options(app, options);
  add_resampling_options(app, options, estimate);
  add_output_options(app, options);
  line.exit_status = parse(app, argc, argv);
  if (line.exit_status) return line;
  if (estimate == Estimate::mean) options.resampling.slope_damping = std::numeric_limits<float>::infinity();
  if (options.path == Path::space && options.gradients) throw InputError("--gradients: the paper's steps have none");
  if (options.work.empty()) options.work = options.out + ".work";
  return line;
}

}  // namespace example::field_bake
