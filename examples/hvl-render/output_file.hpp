#pragma once

#include <filesystem>
#include <functional>

namespace hvl_render {

/// Throws InputError unless a file can be made at `path`; leaves nothing behind.
void check_writable(const std::filesystem::path& path);

/// write(temporary path) makes the file beside its final place, where it then moves in one step: no
/// half-written file is ever seen. Throws InputError when that fails.
void write_in_place(const std::filesystem::path& path,
                    const std::function<void(const std::filesystem::path&)>& write);

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

}  // namespace hvl_render
