#include "output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "input_error.hpp"

namespace example {
namespace {

namespace fs = std::filesystem;

/// A name in the same directory, so that renaming needs no copy.
fs::path temporary_beside(const fs::path& path) {
  fs::path name(".");
  name += path.filename();
  name += ".tmp" + std::to_string(getpid());
  return path.parent_path() / name;
}

/// Where a file really goes: renaming to a symbolic link would replace the link.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real;
}

[[noreturn]] void fail(const fs::path& path, const std::error_code& reason) {
  throw InputError(path.string() + ": cannot be written (" + reason.message() + ")");
}

/// Empty where all went well.
std::error_code write_file(const fs::path& path, const std::string& bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return {};
  return errno != 0 ? std::error_code(errno, std::generic_category()) : std::make_error_code(std::errc::io_error);
}

}  // namespace

void check_writable(const fs::path& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    throw InputError(path.string() + ": is not a regular file");
  }
  OutputBatch().add(path, "");
}

void check_outputs(const std::vector<fs::path>& paths) {
  const auto real = [](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); };
  for (const fs::path& path : paths) {
    check_writable(path);
    const auto same = [&](const fs::path& other) { return real(other) == real(path); };
    if (std::count_if(paths.begin(), paths.end(), same) > 1) {
      throw InputError(path.string() + ": two outputs cannot be one file");
    }
  }
}

OutputBatch::~OutputBatch() {
  std::error_code ignored;
  for (const File& file : files_) fs::remove(file.temporary, ignored);
}

void OutputBatch::add(const fs::path& path, const std::string& bytes) {
  const fs::path place = behind_links(path);
  files_.push_back({temporary_beside(place), place});
  if (const std::error_code reason = write_file(files_.back().temporary, bytes)) fail(path, reason);
}

void OutputBatch::move_into_place() {
  for (const File& file : files_) {
    std::error_code reason;
    fs::rename(file.temporary, file.place, reason);
    if (reason) fail(file.place, reason);
  }
  files_.clear();
}

OutputDirectory::OutputDirectory(fs::path path) : path_(std::move(path)) {
  std::error_code reason;
  made_ = fs::create_directory(path_, reason);
  if (reason) throw InputError(path_.string() + ": cannot be made a directory (" + reason.message() + ")");
}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  // Removes an empty directory only.
  if (made_) fs::remove(path_, ignored);
}

}  // namespace example
