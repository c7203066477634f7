#include "outputs.hpp"

#include <zonal/grid/grid_file.hpp>

#include "shared/image_file.hpp"
#include "shared/input_error.hpp"

namespace example::grid_render {

namespace fs = std::filesystem;

Outputs::Outputs(const Report& planned, const Scene& scene)
    : grid_(planned.options.save_grid), report_(planned.options.report) {
  const Options& options = planned.options;
  const fs::path folder(options.compare_directory);
  if (options.comparing()) directory_.emplace(folder);
  std::vector<fs::path> all;
  for (const Pass& pass : planned.passes) {
    std::vector<fs::path>& pictures = pictures_.emplace_back();
    if (options.comparing()) {
      pictures = {folder / (pass.name + ".png"), folder / (pass.name + ".exr")};
    } else {
      pictures = {options.out};
    }
    all.insert(all.end(), pictures.begin(), pictures.end());
  }
  for (const Comparison& comparison : planned.comparisons) differences_.push_back(folder / (comparison.name + ".png"));
  all.insert(all.end(), differences_.begin(), differences_.end());
  for (const fs::path& path : {grid_, report_}) {
    if (!path.empty()) all.push_back(path);
  }
  std::vector<fs::path> inputs = scene.files;
  inputs.insert(inputs.end(), {options.texture, options.load_grid});
  check_outputs(all, inputs);
}

void Outputs::write(const Report& report, const LightGrid* grid) const {
  const Display& display = report.options.display;
  OutputBatch batch;
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    for (const fs::path& path : pictures_[i]) batch.add(path, picture_bytes(path, report.passes[i].picture, display));
  }
  for (std::size_t i = 0; i < differences_.size(); ++i) {
    const Image& picture = report.passes[report.comparisons[i].picture].picture;
    const Image& reference = report.passes[report.comparisons[i].reference].picture;
    batch.add(differences_[i], png_bytes(amplified_difference(picture, reference, display, difference_factor)));
  }
  if (!report_.empty()) batch.add(report_, json_text(report));
  if (!grid_.empty()) {
    try {
      grid->save(grid_);
    } catch (const zonal::GridFileError& error) {
      throw InputError(one_line(error.what()));
    }
  }
  batch.move_into_place();
}

}  // namespace example::grid_render
