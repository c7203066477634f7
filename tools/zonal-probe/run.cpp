#include "run.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <zonal/transform/rotate.hpp>

#include "coefficients_file.hpp"
#include "conventions.hpp"
#include "picture.hpp"
#include "preview.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/output_file.hpp"
#include "shared/run_program.hpp"
#include "window.hpp"
#include "write.hpp"

namespace zonal_probe {
namespace {

using example::InputError;

constexpr int default_bands = 3;

using Rotation = zonal::Rotation<max_bands, double>;

/// In the frame of pictures: x ahead, y left, z up.
Rotation rotation_of(const std::vector<Turn>& turns) {
  Rotation all;
  for (const Turn& turn : turns) {
    const double axis[3] = {turn.axis == TurnAxis::ahead ? 1.0 : 0.0, turn.axis == TurnAxis::right ? -1.0 : 0.0,
                            turn.axis == TurnAxis::up ? 1.0 : 0.0};
    all = Rotation::from_axis_angle(axis, turn.degrees * pi / 180) * all;
  }
  return all;
}

/// The light, and of a picture what it was read from.
struct Input {
  Light light;
  zonal::Frame frame{};
  std::optional<SkyPicture> sky;
  zonal::PictureFaults faults;
  std::string name, about;
};

zonal::Frame frame_given(const std::optional<std::string>& given, const zonal::Frame& otherwise) {
  zonal::Frame frame = otherwise;
  if (given) parse_frame(*given, frame);
  return frame;
}

void warn(const Options& options, const std::string& text) {
  if (!options.quiet) example::warn(program_name, text);
}

Input read_coefficients_of(const Options& options) {
  if (options.mapping != "auto") throw InputError("--mapping means nothing to coefficients");
  ListOf list;
  list.planes = options.planes;
  if (options.from) list.named = &convention_of("--from", *options.from);
  Stored stored = read_coefficients(options.input, list);
  if (options.bands && *options.bands > stored.bands) {
    throw InputError("--bands: " + options.input + " has " + std::to_string(stored.bands) + ", not " +
                     std::to_string(*options.bands));
  }
  Input input;
  stored.frame = input.frame = frame_given(options.input_frame, stored.frame);
  input.light = load(stored);
  input.about = std::string(stored.named->name) + ", " + quantity_text(stored.quantity) + ", " +
                std::to_string(stored.bands) + (stored.bands == 1 ? " band" : " bands");
  return input;
}

Input read_picture_of(const Options& options) {
  if (options.planes) throw InputError("--planes means nothing to a picture");
  Input input;
  input.sky = read_sky(options.input, options.mapping);
  input.frame = frame_given(options.input_frame, frame_of(input.sky->mapping));
  const example::Image& image = input.sky->image;
  input.about = std::to_string(image.width) + " x " + std::to_string(image.height) + ", " +
                zonal::mapping_name(input.sky->mapping) +
                (input.sky->is_decoded ? ", made linear from 8 bits of sRGB" : "");
  return input;
}

void project(Input& input, const Options& options, int bands, Workers& workers) {
  input.light = project_sky(*input.sky, bands, workers, input.faults);
  input.light.sh = zonal::change_frame(input.light.sh, input.frame, zonal::frames::zonal_picture);
  if (input.faults.total() > 0) {
    warn(options, std::to_string(input.faults.total()) + " numbers of " + input.name +
                      " are no radiance (negative, infinite or none) and count as 0");
  }
}

/// The picture as the viewer sees it who looks ahead, after the turns.
example::Image turned_sky(const Input& input, const Rotation& rotation, Workers& workers) {
  // From the viewer's axes, where the light has been turned, back to the picture's own.
  const zonal::Axes own = zonal::axes_between(zonal::frames::zonal_picture, input.frame);
  const zonal::Axis targets[3] = {own.x, own.y, own.z};
  double turned[3][3], axes[3][3] = {};
  rotation.inverse().get_axes(turned);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      axes[i][zonal::detail::coordinate(targets[k])] = zonal::detail::sign(targets[k]) * turned[i][k];
  }
  return resample_sky(*input.sky, axes, panel_width, panel_height, workers);
}

}  // namespace

void run(const Options& options) {
  if (options.list) {
    std::fputs(convention_list().c_str(), stdout);
    return;
  }
  // All that can be wrong comes to light before the work begins.
  Stored target;
  target.named = &convention_of("--convention", options.convention);
  target.quantity = quantity_of(*target.named, options.quantity ? &*options.quantity : nullptr);
  target.frame = frame_given(options.frame, target.named->frame);
  if (options.bands) check_bands(*target.named, *options.bands);
  std::vector<std::filesystem::path> outputs;
  for (const std::string& path : {options.out, options.preview}) {
    if (!path.empty()) outputs.push_back(path);
  }
  const bool is_picture = !options.from && !is_named_as_coefficients(options.input);
  Input input = is_picture ? read_picture_of(options) : read_coefficients_of(options);
  input.name = example::one_line(std::filesystem::path(options.input).filename().string());
  target.bands = options.bands.value_or(is_picture ? default_bands : input.light.bands);
  check_bands(*target.named, target.bands);
  example::check_outputs(outputs, {options.input});

  Workers workers(options.threads, !options.quiet);
  workers.expect(1.0 + (options.preview.empty() ? 0.0 : 0.5));
  if (is_picture) project(input, options, target.bands, workers);
  Light& light = input.light;
  keep_bands(light, target.bands);
  const Rotation rotation = rotation_of(options.turns);
  if (!options.turns.empty()) light.sh = zonal::rotate(light.sh, rotation);
  const Windowed windowed = apply_window(light, options.window, target.quantity);

  const Stored stored = store(light, target);
  std::vector<std::pair<std::string, std::string>> about{{"source", input.name + ": " + input.about}};
  if (options.window.kind != WindowKind::none) about.push_back({"window", window_text(windowed)});
  const std::string text = output_text(stored, options.format, options.name, about);

  example::OutputBatch batch;
  if (!options.out.empty()) batch.add(options.out, text);
  if (!options.preview.empty()) {
    std::optional<example::Image> sky;
    if (input.sky) sky = turned_sky(input, rotation, workers);
    const PreviewTexts texts{input.about, is_windowed(windowed) ? ", windowed" : ""};
    batch.add(options.preview, example::png_bytes(make_preview(light, sky, texts, workers)));
  }
  example::throw_if_interrupted();
  batch.move_into_place();
  if (options.out.empty()) std::fputs(text.c_str(), stdout);
}

}  // namespace zonal_probe
