#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report.hpp"
#include "shared/output_file.hpp"

namespace example::grid_render {

/// Where the pictures and the report go.
class Outputs {
 public:
  /// Throws InputError unless all can be written.
  Outputs(const Options& options, const std::vector<Pass>& passes);

  /// All or nothing.
  void write(const Report& report) const;

 private:
  /// What to write of a pass; the difference is from the first pass.
  struct Files {
    std::vector<std::filesystem::path> pictures;
    std::filesystem::path difference;  // empty: none
  };
  std::vector<Files> files_;      // of each pass
  std::filesystem::path report_;  // empty: none
  std::optional<OutputDirectory> directory_;
};

}  // namespace example::grid_render
