#include "report_json.hpp"

#include <cmath>

#include "names.hpp"

namespace example {

nlohmann::json number_or_null(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

nlohmann::json point_json(const std::optional<glm::vec3>& point) {
  return point ? nlohmann::json{point->x, point->y, point->z} : nlohmann::json();
}

nlohmann::json degrees_json(const std::optional<float>& radians, float scale) {
  return radians ? nlohmann::json(scale * glm::degrees(*radians)) : nlohmann::json();
}

nlohmann::json camera_json(const CameraOverrides& camera) {
  return {{"camera", point_json(camera.position)},
          {"target", point_json(camera.target)},
          {"fov_degrees", degrees_json(camera.vertical_field_of_view, 1.0f)}};
}

nlohmann::json common_options_json(const CommonOptions& options) {
  return {
      {"scene", options.scene},
      {"stage", options.obj.stage},
      {"up", name_of(up_names, options.obj.up)},
      {"view_from", name_of(place_names, options.obj.place)},
      {"width", options.width},
      {"height", options.height},
      {"antialias", options.antialias},
      {"exposure_stops", options.display.exposure_stops},
      {"tone", name_of(tone_names, options.display.tone_map)},
      {"out", options.comparing() ? options.compare_directory : options.out},
      {"report", options.report},
      {"threads", options.threads},
      {"quiet", options.quiet},
  };
}

nlohmann::json counts_json(const RunCounts& counts) {
  return {{"triangles", counts.triangles},
          {"materials", counts.materials},
          {"primary_samples", counts.primary_samples},
          {"primary_hits", counts.primary_hits},
          {"pixels_not_finite", counts.pixels_not_finite}};
}

nlohmann::json errors_json(const ImageErrors& errors) {
  return {{"mae", number_or_null(errors.mae)},
          {"rmse", number_or_null(errors.rmse)},
          {"psnr_db", number_or_null(errors.psnr)},
          {"ssim", number_or_null(errors.ssim)},
          {"linear_mae_relative_to_mean", number_or_null(errors.linear_mae)},
          {"linear_rmse_relative_to_mean", number_or_null(errors.linear_rmse)}};
}

nlohmann::json report_json(const nlohmann::json& options, const nlohmann::json& counts, const Machine& machine,
                           const StageTimes& times) {
  nlohmann::json json{{"options", options},
                      {"machine", {{"cores", machine.cores}, {"threads", machine.threads}}},
                      {"counts", counts},
                      {"seconds", {{"total", times.total()}}}};
  for (const auto& [stage, seconds] : times.stages()) json["seconds"][stage] = seconds;
  return json;
}

std::string file_text(const nlohmann::json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace example
