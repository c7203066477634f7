#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <zonal/file/output_file.hpp>

namespace example {

/// Throws InputError unless all these files can be made, none is another, and none is one of those that are read,
/// of which there may be empty names. Leaves nothing behind.
void check_outputs(const std::vector<std::filesystem::path>& outputs, const std::vector<std::filesystem::path>& inputs);

/// Files that appear whole and together: each is first written beside its place. One that is given up leaves
/// no trace.
class OutputBatch {
 public:
  void add(const std::filesystem::path& path, const std::string& bytes);  // throws InputError
  void move_into_place();                                                 // throws InputError

 private:
  std::vector<zonal::OutputFile> files_;
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
