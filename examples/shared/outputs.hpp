#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common_options.hpp"
#include "image.hpp"
#include "output_file.hpp"

namespace example {

/// What a run writes, and what it reads.
struct OutputPlan {
  std::vector<std::string> pictures;                            // names; one alone where nothing is compared
  std::vector<std::string> differences = {};                    // names of pictures of differences, where something is
  std::vector<std::filesystem::path> others = {}, inputs = {};  // empty names among them count for nothing
};

/// Where the pictures and the report go: of a comparison each picture as PNG and EXR, and the differences as PNG, in
/// its directory.
class Outputs {
 public:
  /// Throws InputError unless all can be written, and none of the inputs is among them.
  Outputs(const CommonOptions& options, const OutputPlan& plan);

  /// All of them, to be moved into place. Pictures, of linear radiance, and differences, of display values, in the
  /// plan's order.
  OutputBatch prepare(const std::vector<const Image*>& pictures, const std::vector<Image>& differences,
                      const std::string& report) const;

 private:
  Display display_;
  std::vector<std::vector<std::filesystem::path>> pictures_;  // one for each format
  std::vector<std::filesystem::path> differences_;
  std::filesystem::path report_;  // empty: none
  std::optional<OutputDirectory> directory_;
};

}  // namespace example
