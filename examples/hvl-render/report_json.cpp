#include <cmath>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "option_names.hpp"
#include "report.hpp"

namespace hvl_render {
namespace {

nlohmann::json radius_json(const Options& options) {
  if (options.radius == RadiusRule::neighbours) return "r1";
  if (options.radius == RadiusRule::field_of_view) return "r2";
  return options.fixed_radius;
}

nlohmann::json point_json(const std::optional<glm::vec3>& point) {
  return point ? nlohmann::json{point->x, point->y, point->z} : nlohmann::json();
}

nlohmann::json degrees_json(const std::optional<float>& radians, float scale) {
  return radians ? nlohmann::json(scale * glm::degrees(*radians)) : nlohmann::json();
}

/// What the command line set; null is the scene's own.
nlohmann::json view_json(const ViewOverrides& view) {
  return {{"camera", point_json(view.camera_position)},
          {"target", point_json(view.camera_target)},
          {"fov_degrees", degrees_json(view.vertical_field_of_view, 1.0f)},
          {"light", point_json(view.light_position)},
          {"light_target", point_json(view.light_target)},
          {"light_angle_degrees", degrees_json(view.light_half_angle, 2.0f)},
          {"light_power_watts", view.light_power ? nlohmann::json(*view.light_power) : nlohmann::json()}};
}

nlohmann::json options_json(const Options& options) {
  return {
      {"scene", options.scene},
      {"stage", options.stage},
      {"view", view_json(options.view)},
      {"method", options.comparing() ? "compare" : name_of(method_names, options.method)},
      {"lights", options.lights},
      {"bands", options.bands},
      {"emission_bands", options.emission_bands},
      {"radius", radius_json(options)},
      {"radius_factor", options.radius_factor},
      {"horizon", name_of(horizon_names, options.horizon)},
      {"window", name_of(window_names, options.window)},
      {"samples_per_pixel", options.samples_per_pixel},
      {"bounces", options.bounces},
      {"seed", options.seed},
      {"width", options.width},
      {"height", options.height},
      {"antialias", options.antialias},
      {"exposure_stops", options.display.exposure_stops},
      {"tone", name_of(tone_names, options.display.tone_map)},
      {"out", options.comparing() ? options.compare_directory : options.out},
      {"reference", options.reference},
      {"report", options.report},
      {"threads", options.threads},
      {"quiet", options.quiet},
  };
}

/// JSON has no infinity: the PSNR of equal images is null.
nlohmann::json number_or_null(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

nlohmann::json errors_json(const ImageErrors& errors) {
  return {{"rmse", number_or_null(errors.rmse)},
          {"psnr_db", number_or_null(errors.psnr)},
          {"ssim", number_or_null(errors.ssim)},
          {"linear_rmse_relative_to_mean", number_or_null(errors.linear_rmse)}};
}

nlohmann::json counts_json(const Counts& counts) {
  return {{"triangles", counts.triangles},
          {"materials", counts.materials},
          {"map_lights", counts.map_lights},
          {"virtual_lights", counts.virtual_lights},
          {"primary_samples", counts.primary_samples},
          {"primary_hits", counts.primary_hits},
          {"paths_per_pixel", counts.samples_per_pixel},
          {"pixels_not_finite", counts.pixels_not_finite}};
}

nlohmann::json times_json(const StageTimes& times) {
  nlohmann::json json;
  for (const auto& [stage, seconds] : times.stages()) json[stage] = seconds;
  json["total"] = times.total();
  return json;
}

}  // namespace

std::string json_text(const Report& report) {
  nlohmann::json json;
  json["options"] = options_json(report.options);
  json["machine"] = {{"cores", report.machine_cores}, {"threads", report.threads}};
  json["counts"] = counts_json(report.counts);
  json["seconds"] = times_json(report.times);
  if (report.options.needs_lights()) {
    json["material_projection_error"] = report.material_error;
    json["gather_ns_per_hit_and_light"] = nanoseconds_per_gather(report);
  }
  if (report.errors) json["errors"] = errors_json(*report.errors);
  if (report.options.comparing()) {
    json["difference_map"] = {{"quantity", "display luma, hvl minus reference"},
                              {"red", "hvl is brighter"},
                              {"blue", "hvl is darker"},
                              {"saturates_at", difference_full_scale}};
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace hvl_render
