#include "output_file.hpp"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "scene.hpp"

namespace hvl_render {
namespace {

namespace fs = std::filesystem;

/// A name in the same directory, so that renaming needs no copy.
fs::path temporary_beside(const fs::path& path) {
  fs::path name(".");
  name += path.stem();
  name += ".tmp" + std::to_string(getpid());
  name += path.extension();
  return path.parent_path() / name;
}

/// Removes the file when it goes, unless that has moved away.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void check_writable(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw InputError(path.string() + ": is a directory");
  const TemporaryFile probe(temporary_beside(path));
  if (!std::ofstream(probe.path())) throw InputError(path.string() + ": cannot be written");
}

void write_in_place(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const TemporaryFile temporary(temporary_beside(path));
  try {
    write(temporary.path());
    fs::rename(temporary.path(), path);
  } catch (const std::exception&) {
    throw InputError(path.string() + ": cannot be written");
  }
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  made_ = fs::create_directory(path_, error);
  if (!fs::is_directory(path_, error)) throw InputError(path_.string() + ": cannot be made a directory");
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  // Removes an empty directory only.
  if (made_) fs::remove(path_, ignored);
}

}  // namespace hvl_render
