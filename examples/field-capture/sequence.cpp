#include "sequence.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

#include <tbb/parallel_for.h>
#include <zonal/file/number_text.hpp>

#include "option_names.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/output_file.hpp"

namespace example::field_capture {
namespace {

namespace fs = std::filesystem;

/// All that pictures depend on.
std::string settings_text(const Options& options, const Bounds& box) {
  const auto point = [](const glm::vec3& p) {
    return zonal::shortest_text(p.x) + " " + zonal::shortest_text(p.y) + " " + zonal::shortest_text(p.z);
  };
  return "scene " + options.scene + "\nstage " + std::to_string(options.obj.stage) + " " +
         name_of(up_names, options.obj.up) + "\nsetup " + name_of(field_setup_names, options.setup) + "\nbox " +
         point(box.lower) + " " + point(box.upper) + "\nprobes " + std::to_string(options.probes) + " " +
         name_of(layout_names, options.layout) + "\npictures " + std::to_string(options.side) + " " +
         zonal::mapping_name(options.mapping) + "\nsphere-radius " + zonal::shortest_text(*options.sphere_radius) +
         "\ndead-angle " + zonal::shortest_text(options.dead_angle) + "\npaths " + std::to_string(options.samples) +
         " " + std::to_string(options.bounces) + " " + std::to_string(options.seed) + "\n";
}

void write_file(const fs::path& path, const std::string& bytes) {
  OutputBatch batch;
  batch.add(path, bytes);
  batch.move_into_place();
}

/// A folder of these settings, or of none.
void claim(const fs::path& folder, const std::string& settings) {
  const fs::path path = folder / "settings.txt";
  if (std::ifstream file(path, std::ios::binary); file) {
    const std::string found{std::istreambuf_iterator<char>(file), {}};
    if (found != settings) {
      throw InputError(path.string() + ": says that the folder's probes are of other settings; name another folder");
    }
  } else if (fs::exists(folder / "sequence.txt")) {
    throw InputError((folder / "sequence.txt").string() + ": is of another program, and is not overwritten");
  }
  write_file(path, settings);  // also where it is there already: whether it can be done shows now
}

fs::path picture_path(const fs::path& folder, std::size_t number) {
  const std::string digits = std::to_string(number);
  return folder / ("probe-" + std::string(5 - std::min<std::size_t>(digits.size(), 5), '0') + digits + ".exr");
}

bool is_whole(const fs::path& path, const ProbeCamera& camera) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  try {
    const Image picture = read_exr(path);
    return picture.width == camera.width && picture.height == camera.height;
  } catch (const InputError&) {
    return false;
  }
}

void write_done(const fs::path& folder, const std::vector<glm::vec3>& positions, const std::vector<char>& done,
                const Options& options, const ProbeCamera& camera) {
  zonal::ProbeSequence sequence;
  sequence.mapping = camera.mapping;
  sequence.sphere_radius = static_cast<float>(camera.sphere_radius);
  sequence.dead_angle = static_cast<float>(camera.dead_angle);
  sequence.dead_angle_is = options.dead_angle_is;
  sequence.orientation = picture_orientation();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (done[i] != 0) sequence.probes.push_back({picture_path(folder, i), positions[i], std::nullopt});
  }
  if (sequence.probes.empty()) return;
  try {
    zonal::write_sequence(folder / "sequence.txt", sequence);
  } catch (const zonal::FileError& error) {
    throw InputError(one_line(error.what()));
  }
}

}  // namespace

Captured capture_sequence(const fs::path& folder, const std::vector<glm::vec3>& positions, const Options& options,
                          const Bounds& box, const IncidentRadiance& light) {
  ProbeCamera camera = ProbeCamera::of_side(options.mapping, options.side);
  camera.sphere_radius = *options.sphere_radius;
  camera.dead_angle = glm::radians(options.dead_angle);
  const OutputDirectory directory(folder);
  claim(folder, settings_text(options, box));

  std::vector<char> done(positions.size());
  tbb::parallel_for(std::size_t{0}, positions.size(),
                    [&](std::size_t i) { done[i] = is_whole(picture_path(folder, i), camera); });
  Captured captured;
  captured.kept = static_cast<std::size_t>(std::count(done.begin(), done.end(), 1));
  Progress progress(!options.quiet);
  progress.expect(static_cast<double>(positions.size() - captured.kept));
  const auto start = std::chrono::steady_clock::now();
  tbb::parallel_for(std::size_t{0}, positions.size(), [&](std::size_t i) {
    if (done[i] != 0 || stop_requested()) return;
    const Image picture = capture_probe(camera, light, positions[i], options.samples, hash64(options.seed) + i);
    if (stop_requested()) return;
    write_file(picture_path(folder, i), exr_bytes(picture));
    done[i] = 1;
    progress.advance("probes", 1.0);
  });
  captured.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  captured.probes = static_cast<std::size_t>(std::count(done.begin(), done.end(), 1));
  write_done(folder, positions, done, options, camera);
  if (stop_requested()) {
    throw Interrupted{std::to_string(captured.probes) + " of " + std::to_string(positions.size()) +
                      " probes are in the folder"};
  }
  return captured;
}

}  // namespace example::field_capture
