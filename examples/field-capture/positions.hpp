#pragma once

#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

#include "options.hpp"
#include "shared/scene.hpp"

namespace example::field_capture {

/// Places of about options.probes probes, each near the one before, as a stage would move.
std::vector<glm::vec3> probe_positions(const Options& options, const Bounds& box);

/// x y z, a line each; '#' begins a comment. Throws InputError.
std::vector<glm::vec3> read_positions(const std::filesystem::path& path);

}  // namespace example::field_capture
