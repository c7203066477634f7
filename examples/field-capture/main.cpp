// field-capture: sequences of light probes of a scene in two set-ups (Loew et al., HDR light probe sequence resampling
// for realtime incident light field rendering, SCCG 2009), and what truly arrives where.
#include <cstdio>
#include <string>
#include <vector>

#include "options.hpp"
#include "positions.hpp"
#include "sequence.hpp"
#include "shared/input_error.hpp"
#include "shared/output_file.hpp"
#include "shared/program.hpp"
#include "shared/view.hpp"
#include "truth.hpp"

namespace example::field_capture {
namespace {

constexpr const char* program_name = "field-capture";

void write_truth(const Options& options, const std::vector<glm::vec3>& positions, const IncidentRadiance& light) {
  const std::string text =
      truth_csv(light, positions, options.bands, options.truth_samples, options.seed, options.quiet);
  OutputBatch batch;
  batch.add(options.out, text);
  batch.move_into_place();
  if (!options.quiet)
    std::printf("%zu positions, %d bands: %s\n", positions.size(), options.bands, options.out.c_str());
}

void print(const Options& options, const Captured& captured) {
  std::printf("%zu probes in %s", captured.probes, options.out.c_str());
  if (captured.kept > 0) std::printf(", of which %zu were there", captured.kept);
  const std::size_t made = captured.probes - captured.kept;
  if (made > 0) std::printf("; %.1f s, %.0f ms each", captured.seconds, 1e3 * captured.seconds / double(made));
  std::printf("\n");
}

void run(const Options& options) {
  const ThreadLimit limit(options.threads);
  Scene scene = open_scene(options);
  print_warnings(program_name, scene);
  const Bounds box = field_box(scene, options.box);
  const bool is_truth = !options.truth.empty();
  const std::vector<glm::vec3> positions = is_truth ? read_positions(options.truth) : probe_positions(options, box);
  if (is_truth) {
    std::vector<std::filesystem::path> inputs = scene.files;
    inputs.emplace_back(options.truth);
    check_outputs({options.out}, inputs);
  }
  std::vector<Emitter> emitters = set_up_field(options.setup, box, scene);
  const RayCaster caster(scene);
  const IncidentRadiance light(scene, caster, std::move(emitters), options.bounces);
  if (is_truth) return write_truth(options, positions, light);
  const Captured captured = capture_sequence(options.out, positions, options, box, light);
  if (!options.quiet) print(options, captured);
}

}  // namespace
}  // namespace example::field_capture

int main(int argc, char** argv) {
  using namespace example::field_capture;
  return example::run_program(program_name, argc, argv, parse_command_line, run);
}
