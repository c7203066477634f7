// The one way in which this project writes a file: whole, or not at all.
//
// A file is written beside its place and moved there when it is whole, so that whoever reads meanwhile, or after a
// failure, has the old one. What is found at the place keeps its meaning: a link stays a link, and mode and owner stay
// what they were (the owner as far as the system lets us). What is not a regular file, a device or a pipe say, is
// refused: moving a file to its place would take it away.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#if __has_include(<unistd.h>)
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "file_error.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Where a file at `path` really stands or would stand: at the end of all links, dangling ones as well.
inline std::filesystem::path behind_links(std::filesystem::path path) {
  for (int links = 0; links < 40; ++links) {
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) return path;
    path = path.parent_path() / std::filesystem::read_symlink(path, error);  // an absolute target stands alone
    if (error) throw FileError(path, "cannot be written (" + error.message() + ")");
  }
  throw FileError(path, "cannot be written (too many links)");
}

/// A file on its way. All failures are FileError; one that is given up leaves no trace.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path) : name_(path), place_(behind_links(path)) {
    std::error_code error;
    const auto there = std::filesystem::status(place_, error);
    const bool exists = std::filesystem::exists(there);
    if (exists && !std::filesystem::is_regular_file(there)) throw FileError(name_, "is not a regular file");
    if (there.type() == std::filesystem::file_type::none) fail(error);
    errno = 0;
    if (exists && !std::fstream(place_, std::ios::binary | std::ios::in | std::ios::out)) fail();  // is protected

    temporary_ = place_.parent_path() / (".zonal-" + std::to_string(random_number()) + ".tmp");
    file_.open(temporary_, std::ios::binary);
    if (!file_) {
      temporary_.clear();
      fail();
    }
    if (exists) keep_mode_and_owner(there.permissions());
  }
  ~OutputFile() { give_up(); }
  OutputFile(OutputFile&& other) noexcept { swap(other); }
  OutputFile& operator=(OutputFile&& other) noexcept {
    swap(other);
    return *this;
  }

  void write(const void* bytes, std::size_t count) {
    errno = 0;
    if (!file_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count))) fail();
  }
  /// All bytes have arrived.
  void close() {
    errno = 0;
    file_.close();
    if (!file_) fail();
  }
  /// The last step.
  void move_into_place() {
    if (file_.is_open()) close();
    std::error_code error;
    std::filesystem::rename(temporary_, place_, error);
    if (error) fail(error);
    temporary_.clear();
  }

 private:
  static std::uint64_t random_number() {
    std::random_device random;
    return static_cast<std::uint64_t>(random()) << 32 | random();
  }

  void keep_mode_and_owner(std::filesystem::perms mode) const {
    std::error_code ignored;
#if __has_include(<unistd.h>)
    struct stat there;
    if (stat(place_.c_str(), &there) == 0 && chown(temporary_.c_str(), there.st_uid, there.st_gid) != 0) {
      ignored.assign(errno, std::generic_category());  // another user's file in a folder of ours
    }
#endif
    std::filesystem::permissions(temporary_, mode, ignored);
  }

  void give_up() {
    std::error_code ignored;
    file_.close();
    if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
  }

  void swap(OutputFile& other) noexcept {
    name_.swap(other.name_);
    place_.swap(other.place_);
    temporary_.swap(other.temporary_);
    file_.swap(other.file_);
  }

  [[noreturn]] void fail(std::error_code reason = {errno != 0 ? errno : EIO, std::generic_category()}) const {
    throw FileError(name_, "cannot be written (" + reason.message() + ")");
  }

  std::filesystem::path name_, place_, temporary_;  // no temporary: all is done, or none was made
  std::ofstream file_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
