#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "common_options.hpp"
#include "image.hpp"
#include "stage_times.hpp"

namespace example {

/// JSON has no infinity: what is not finite is null.
nlohmann::json number_or_null(double value);

/// What the command line did not set is null.
nlohmann::json point_json(const std::optional<glm::vec3>& point);
nlohmann::json degrees_json(const std::optional<float>& radians, float scale);
nlohmann::json camera_json(const CameraOverrides& camera);

/// All but the camera and the output.
nlohmann::json common_options_json(const CommonOptions& options);

nlohmann::json counts_json(const RunCounts& counts);
nlohmann::json errors_json(const ImageErrors& errors);

/// What every report begins with.
nlohmann::json report_json(const nlohmann::json& options, const nlohmann::json& counts, const Machine& machine,
                           const StageTimes& times);

/// The text of a file.
std::string file_text(const nlohmann::json& json);

}  // namespace example
