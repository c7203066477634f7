#include "outputs.hpp"

#include "option_names.hpp"
#include "shared/image_file.hpp"

namespace example::hvl_render {

namespace fs = std::filesystem;

Outputs::Outputs(const Options& options, const Scene& scene) : report_(options.report) {
  if (options.comparing()) {
    const fs::path folder(options.compare_directory);
    directory_.emplace(folder);
    const std::string method = name_of(method_names, options.method);
    lights_ = {folder / (method + ".png"), folder / (method + ".exr")};
    reference_ = {folder / "reference.png", folder / "reference.exr"};
    difference_ = folder / "difference.png";
  } else {
    picture_ = options.out;
  }
  std::vector<fs::path> inputs = scene.files;
  for (const Material& material : scene.materials) inputs.push_back(material.file);
  inputs.push_back(options.reference);
  check_outputs(all(), inputs);
}

std::vector<fs::path> Outputs::all() const {
  std::vector<fs::path> paths;
  for (const fs::path& path : {picture_, report_, difference_}) {
    if (!path.empty()) paths.push_back(path);
  }
  paths.insert(paths.end(), lights_.begin(), lights_.end());
  paths.insert(paths.end(), reference_.begin(), reference_.end());
  return paths;
}

void Outputs::write(const Pictures& pictures, const Report& report) const {
  const Display& display = report.options.display;
  OutputBatch batch;
  for (const fs::path& path : lights_) batch.add(path, picture_bytes(path, pictures.lights, display));
  for (const fs::path& path : reference_) batch.add(path, picture_bytes(path, pictures.path, display));
  if (!difference_.empty()) {
    batch.add(difference_, png_bytes(difference_map(pictures.lights, pictures.path, display)));
  }
  if (!picture_.empty()) {
    const Image& only = pictures.lights.width > 0 ? pictures.lights : pictures.path;
    batch.add(picture_, picture_bytes(picture_, only, display));
  }
  if (!report_.empty()) batch.add(report_, json_text(report));
  batch.move_into_place();
}

}  // namespace example::hvl_render
