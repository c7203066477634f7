#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace example {

/// Throws InputError unless a regular file can be made at `path`; leaves nothing behind.
void check_writable(const std::filesystem::path& path);

/// Throws InputError unless all these files can be made, and none is another.
void check_outputs(const std::vector<std::filesystem::path>& paths);

/// Files that appear whole and together: each is first written beside its place. One that is given up leaves
/// no trace.
class OutputBatch {
 public:
  OutputBatch() = default;
  ~OutputBatch();
  OutputBatch(const OutputBatch&) = delete;
  OutputBatch& operator=(const OutputBatch&) = delete;

  void add(const std::filesystem::path& path, const std::string& bytes);  // throws InputError
  void move_into_place();                                                 // throws InputError

 private:
  struct File {
    std::filesystem::path temporary;
    std::filesystem::path place;
  };
  std::vector<File> files_;
};

/// A directory for outputs: made if missing, and taken away again if nothing was put into it.
class OutputDirectory {
 public:
  explicit OutputDirectory(std::filesystem::path path);  // throws InputError
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

 private:
  std::filesystem::path path_;
  bool made_ = false;
};

}  // namespace example
