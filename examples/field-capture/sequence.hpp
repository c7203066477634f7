#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "options.hpp"
#include "probe.hpp"
#include "shared/progress.hpp"

namespace example::field_capture {

struct Captured {
  std::size_t probes = 0, kept = 0;  // kept: of those, what an earlier run left
  double seconds = 0.0;              // of the others
};

/// Pictures of all positions in the folder, and sequence.txt beside them; settings.txt says what they were made with.
/// A picture is kept that is there whole and of the right size; a folder of other settings is refused. Throws
/// InputError, and Interrupted once sequence.txt names those that are done.
Captured capture_sequence(const std::filesystem::path& folder, const std::vector<glm::vec3>& positions,
                          const Options& options, const Bounds& box, const IncidentRadiance& light);

}  // namespace example::field_capture
