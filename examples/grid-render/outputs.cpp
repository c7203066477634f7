#include "outputs.hpp"

#include "shared/image_file.hpp"

namespace example::grid_render {

namespace fs = std::filesystem;

Outputs::Outputs(const Options& options, const std::vector<Pass>& passes) : report_(options.report) {
  const fs::path folder(options.compare_directory);
  if (options.comparing()) directory_.emplace(folder);
  std::vector<fs::path> all;
  for (const Pass& pass : passes) {
    Files& files = files_.emplace_back();
    if (options.comparing()) {
      files.pictures = {folder / (pass.name + ".png"), folder / (pass.name + ".exr")};
      if (&pass != &passes.front()) files.difference = folder / (pass.name + "-difference.png");
    } else {
      files.pictures = {options.out};
    }
    all.insert(all.end(), files.pictures.begin(), files.pictures.end());
    if (!files.difference.empty()) all.push_back(files.difference);
  }
  if (!report_.empty()) all.push_back(report_);
  check_outputs(all);
}

void Outputs::write(const Report& report) const {
  const Display& display = report.options.display;
  OutputBatch batch;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const Image& picture = report.passes[i].picture;
    for (const fs::path& path : files_[i].pictures) batch.add(path, picture_bytes(path, picture, display));
    if (files_[i].difference.empty()) continue;
    const Image& reference = report.passes.front().picture;
    batch.add(files_[i].difference, png_bytes(amplified_difference(picture, reference, display, difference_factor)));
  }
  if (!report_.empty()) batch.add(report_, json_text(report));
  batch.move_into_place();
}

}  // namespace example::grid_render
