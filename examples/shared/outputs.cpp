#include "outputs.hpp"

#include "image_file.hpp"

namespace example {

namespace fs = std::filesystem;

Outputs::Outputs(const CommonOptions& options, const OutputPlan& plan)
    : display_(options.display), report_(options.report) {
  const fs::path folder(options.compare_directory);
  if (options.comparing()) directory_.emplace(folder);
  for (const std::string& name : plan.pictures) {
    if (options.comparing()) {
      pictures_.push_back({folder / (name + ".png"), folder / (name + ".exr")});
    } else {
      pictures_.push_back({options.out});
    }
  }
  for (const std::string& name : plan.differences) differences_.push_back(folder / (name + ".png"));

  std::vector<fs::path> all = differences_;
  for (const auto& formats : pictures_) all.insert(all.end(), formats.begin(), formats.end());
  if (!report_.empty()) all.push_back(report_);
  for (const fs::path& path : plan.others) {
    if (!path.empty()) all.push_back(path);
  }
  check_outputs(all, plan.inputs);
}

OutputBatch Outputs::prepare(const std::vector<const Image*>& pictures, const std::vector<Image>& differences,
                             const std::string& report) const {
  OutputBatch batch;
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    for (const fs::path& path : pictures_[i]) batch.add(path, picture_bytes(path, *pictures.at(i), display_));
  }
  for (std::size_t i = 0; i < differences_.size(); ++i) batch.add(differences_[i], png_bytes(differences.at(i)));
  if (!report_.empty()) batch.add(report_, report);
  return batch;
}

}  // namespace example
