#include "outputs.hpp"

#include <algorithm>

#include "image_file.hpp"
#include "input_error.hpp"

namespace hvl_render {
namespace {

namespace fs = std::filesystem;

std::string picture_bytes(const fs::path& path, const Image& radiance, const Display& display) {
  return path.extension() == ".exr" ? exr_bytes(radiance) : png_bytes(encode(radiance, display));
}

}  // namespace

Outputs::Outputs(const Options& options) : report_(options.report) {
  if (options.comparing()) {
    const fs::path folder(options.compare_directory);
    directory_.emplace(folder);
    hvl_ = {folder / "hvl.png", folder / "hvl.exr"};
    reference_ = {folder / "reference.png", folder / "reference.exr"};
    difference_ = folder / "difference.png";
  } else {
    picture_ = options.out;
  }
  const auto real = [](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); };
  const std::vector<fs::path> paths = all();
  for (const fs::path& path : paths) {
    check_writable(path);
    const auto same = [&](const fs::path& other) { return real(other) == real(path); };
    if (std::count_if(paths.begin(), paths.end(), same) > 1) {
      throw InputError(path.string() + ": two outputs cannot be one file");
    }
  }
}

std::vector<fs::path> Outputs::all() const {
  std::vector<fs::path> paths;
  for (const fs::path& path : {picture_, report_, difference_}) {
    if (!path.empty()) paths.push_back(path);
  }
  paths.insert(paths.end(), hvl_.begin(), hvl_.end());
  paths.insert(paths.end(), reference_.begin(), reference_.end());
  return paths;
}

void Outputs::write(const Pictures& pictures, const Report& report) const {
  const Display& display = report.options.display;
  OutputBatch batch;
  for (const fs::path& path : hvl_) batch.add(path, picture_bytes(path, pictures.hvl, display));
  for (const fs::path& path : reference_) batch.add(path, picture_bytes(path, pictures.path, display));
  if (!difference_.empty()) {
    batch.add(difference_, png_bytes(difference_map(pictures.hvl, pictures.path, display)));
  }
  if (!picture_.empty()) {
    const Image& only = pictures.hvl.width > 0 ? pictures.hvl : pictures.path;
    batch.add(picture_, picture_bytes(picture_, only, display));
  }
  if (!report_.empty()) batch.add(report_, json_text(report));
  batch.move_into_place();
}

}  // namespace hvl_render
