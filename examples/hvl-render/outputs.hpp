#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "options.hpp"
#include "report.hpp"
#include "shared/image.hpp"
#include "shared/output_file.hpp"
#include "shared/scene.hpp"

namespace example::hvl_render {

/// Linear radiance; an image that no one asked for is empty.
struct Pictures {
  Image lights;  // by virtual lights
  Image path;
};

/// Where the pictures and the report go.
class Outputs {
 public:
  Outputs(const Options& options, const Scene& scene);  // throws InputError unless all can be written

  /// All or nothing.
  void write(const Pictures& pictures, const Report& report) const;

 private:
  std::vector<std::filesystem::path> all() const;

  // Empty where there is none.
  std::filesystem::path picture_;
  std::filesystem::path report_;
  std::vector<std::filesystem::path> lights_, reference_;  // one for each format
  std::filesystem::path difference_;
  std::optional<OutputDirectory> directory_;
};

}  // namespace example::hvl_render
