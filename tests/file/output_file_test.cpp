// Files that are whole or not there, and what is found at their place.
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include <zonal/file/output_file.hpp>

#include "catch.hpp"
#include "files.hpp"

namespace fs = std::filesystem;

using file_test::bytes_of;
using file_test::contains;

namespace {

void write_whole(const fs::path& path, const std::string& bytes) {
  zonal::OutputFile file(path);
  file.write(bytes.data(), bytes.size());
  file.move_into_place();
}

std::string error_of(const fs::path& path) {
  try {
    write_whole(path, "new");
  } catch (const zonal::FileError& error) {
    return error.what();
  }
  return "";
}

struct stat status_of(const fs::path& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status;
}

/// No file may grow beyond so many bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("a file appears when it is whole, and one that is given up leaves nothing") {
  const file_test::Folder folder;
  const fs::path path = folder.path / "x";
  {
    zonal::OutputFile file(path);
    file.write("abc", 3);
    file.close();
    CHECK(!fs::exists(path));
    zonal::OutputFile moved(std::move(file));
    moved.move_into_place();
    CHECK(bytes_of(path) == "abc");
  }
  {
    zonal::OutputFile file(path);
    file.write("other", 5);
  }
  CHECK(bytes_of(path) == "abc");
  CHECK(folder.files() == 1);
}

TEST_CASE("a disk that fills up costs neither the old file nor room") {
  const file_test::Folder folder;
  const fs::path path = folder.path / "x";
  file_test::write(path, "old");
  for (const std::size_t size : {std::size_t{5000}, std::size_t{500000}}) {  // found by close, and by write
    const std::string bytes(size, 'x');
    std::string error;
    {
      const FullDisk disk(4096);
      try {
        write_whole(path, bytes);
      } catch (const zonal::FileError& failure) {
        error = failure.what();
      }
    }
    INFO(error);
    CHECK(contains(error, "x: cannot be written (File too large)"));
    CHECK(bytes_of(path) == "old");
    CHECK(folder.files() == 1);
  }
}

TEST_CASE("links stay links: to a file, to another folder, through links, to nothing yet") {
  const file_test::Folder folder;
  fs::create_directory(folder.path / "sub");
  file_test::write(folder.path / "sub/real", "old");
  fs::create_symlink("sub/real", folder.path / "near");
  fs::create_symlink(folder.path / "near", folder.path / "far");
  fs::create_symlink("sub/later", folder.path / "dangling");
  for (const auto& [link, real] : {std::pair("near", "sub/real"), std::pair("far", "sub/real"),
                                   std::pair("dangling", "sub/later"), std::pair("dangling", "sub/later")}) {
    INFO(link);
    write_whole(folder.path / link, std::string("by ") + link);
    CHECK(fs::is_symlink(folder.path / link));
    CHECK(fs::is_regular_file(fs::symlink_status(folder.path / real)));
    CHECK(bytes_of(folder.path / real) == std::string("by ") + link);
  }
  fs::create_symlink("loop", folder.path / "loop");
  CHECK(contains(error_of(folder.path / "loop"), "cannot be written (too many links)"));
}

TEST_CASE("mode and owner stay; a new file has those of any new file") {
  const file_test::Folder folder;
  const fs::path path = folder.path / "x";
  for (const mode_t mode : {mode_t{0600}, mode_t{0644}, mode_t{0755}, mode_t{0666}}) {
    file_test::write(path, "old");
    REQUIRE(chmod(path.c_str(), mode) == 0);
    const bool is_given = chown(path.c_str(), 12345, 23456) == 0;  // root alone can
    const struct stat before = status_of(path);
    write_whole(path, "new");
    const struct stat after = status_of(path);
    CHECK((after.st_mode & 07777) == mode);
    CHECK(after.st_uid == before.st_uid);
    CHECK(after.st_gid == before.st_gid);
    CHECK(after.st_uid == (is_given ? 12345 : getuid()));
    CHECK(bytes_of(path) == "new");
  }
  const mode_t mask = umask(027);
  write_whole(folder.path / "fresh", "new");
  umask(mask);
  CHECK((status_of(folder.path / "fresh").st_mode & 07777) == 0640);
}

TEST_CASE("what is no regular file, or cannot be one, is refused and left alone") {
  const file_test::Folder folder;
  fs::create_directory(folder.path / "folder");
  REQUIRE(mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("/dev/null", folder.path / "link_to_device");
  fs::create_symlink("folder", folder.path / "link_to_folder");
  file_test::write(folder.path / "file", "old");
  const std::size_t files = folder.files();
  for (const char* name : {"folder", "pipe", "link_to_device", "link_to_folder"}) {
    CHECK(contains(error_of(folder.path / name), std::string(name) + ": is not a regular file"));
  }
  CHECK(contains(error_of("/dev/full"), "is not a regular file"));
  CHECK(contains(error_of(folder.path / "nowhere/x"), "cannot be written (No such file or directory)"));
  CHECK(contains(error_of(folder.path / "file/x"), "cannot be written (Not a directory)"));
  CHECK(contains(error_of(folder.path / std::string(300, 'x')), "cannot be written (File name too long)"));
  CHECK(error_of(folder.path / std::string(255, 'x')).empty());  // the longest there can be
  CHECK(folder.files() == files + 1);
  CHECK(fs::is_fifo(folder.path / "pipe"));
  CHECK(fs::is_symlink(folder.path / "link_to_device"));
  CHECK(bytes_of(folder.path / "file") == "old");
  if (geteuid() != 0) {  // root may write it
    fs::permissions(folder.path / "file", fs::perms::owner_read);
    CHECK(contains(error_of(folder.path / "file"), "cannot be written (Permission denied)"));
  }
}
