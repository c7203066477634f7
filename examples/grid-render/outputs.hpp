#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lighting.hpp"
#include "report.hpp"
#include "shared/output_file.hpp"

namespace example::grid_render {

/// Where the pictures, the grid and the report go.
class Outputs {
 public:
  /// Throws InputError unless all can be written.
  Outputs(const Report& planned, const Scene& scene);

  /// All or nothing. `grid` is the one to save, if any.
  void write(const Report& report, const LightGrid* grid) const;

 private:
  std::vector<std::vector<std::filesystem::path>> pictures_;  // of each pass
  std::vector<std::filesystem::path> differences_;            // of each comparison
  std::filesystem::path grid_, report_;                       // empty: none
  std::optional<OutputDirectory> directory_;
};

}  // namespace example::grid_render
