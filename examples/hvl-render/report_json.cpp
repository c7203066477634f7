#include "shared/report_json.hpp"
#include "option_names.hpp"
#include "report.hpp"

namespace example::hvl_render {
namespace {

nlohmann::json radius_json(const Options& options) {
  if (options.radius == RadiusRule::neighbours) return "r1";
  if (options.radius == RadiusRule::field_of_view) return "r2";
  return options.fixed_radius;
}

/// What the command line set; null is the scene's own.
nlohmann::json view_json(const Options& options) {
  const LightOverrides& light = options.light;
  nlohmann::json json = camera_json(options.camera);
  json.update({{"light", point_json(light.position)},
               {"light_target", point_json(light.target)},
               {"light_angle_degrees", degrees_json(light.half_angle, 2.0f)},
               {"light_power_watts", light.power ? nlohmann::json(*light.power) : nlohmann::json()}});
  return json;
}

nlohmann::json materials_json(const std::vector<MaterialChange>& changes) {
  nlohmann::json json = nlohmann::json::array();
  for (const MaterialChange& change : changes) json.push_back(change.name + "=" + change.spec);
  return json;
}

nlohmann::json options_json(const Options& options) {
  nlohmann::json json = common_options_json(options);
  json.update({{"view", view_json(options)},
               {"method", name_of(method_names, options.method)},
               {"compare", options.comparing()},
               {"time_budget_seconds", options.time_budget ? nlohmann::json(*options.time_budget) : nlohmann::json()},
               {"material_cache", options.material_cache},
               {"visibility", name_of(visibility_names, options.centre_visibility)},
               {"vpl_clamp", options.vpl_clamp},
               {"vsl_samples", options.vsl_samples},
               {"vsgl_texels", options.vsgl_texels},
               {"materials", materials_json(options.materials)},
               {"multiple_scattering", options.multiple_scattering},
               {"lights", options.lights},
               {"bands", options.bands},
               {"emission_bands", options.emission_bands},
               {"radius", radius_json(options)},
               {"radius_factor", options.radius_factor},
               {"horizon", name_of(horizon_names, options.horizon)},
               {"window", name_of(window_names, options.window)},
               {"tolerance", options.tolerance},
               {"checked_share", options.checked_share},
               {"samples_per_pixel", options.samples_per_pixel},
               {"bounces", options.bounces},
               {"seed", options.seed},
               {"reference", options.reference}});
  return json;
}

nlohmann::json counts_json(const Counts& counts) {
  nlohmann::json json = example::counts_json(counts);
  json.update({{"map_lights", counts.map_lights},
               {"virtual_lights", counts.virtual_lights},
               {"paths_per_pixel", counts.samples_per_pixel}});
  return json;
}

nlohmann::json budget_json(const Report& report) {
  return {{"given_seconds", *report.options.time_budget},
          {"lights", report.options.lights},
          {"took_seconds", light_seconds(report)}};
}

/// As docs/rooms/plan.md has it, for zonal-glsl --plan.
nlohmann::json coefficients_json(const zonal::CoefficientPlan& plan) {
  const char* const names[] = {"zonal", "mirror", "none"};
  nlohmann::json left_out = nlohmann::json::array();
  for (int l = 0; l < plan.bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      if (has_order(plan.symmetry, m) && !plan.keeps(l, m)) left_out.push_back({l, m});
    }
  }
  return {{"symmetry", names[static_cast<int>(plan.symmetry)]},
          {"bands", plan.bands},
          {"left_out", left_out},
          {"coefficients", plan.kept_count()},
          {"mean_error", plan.error.mean},
          {"worst_error", plan.error.worst}};
}

nlohmann::json plan_json(const Report& report) {
  nlohmann::json materials = nlohmann::json::array();
  for (std::size_t i = 0; i < report.scene_plan->materials.size(); ++i) {
    const MaterialNeeds& needs = report.scene_plan->materials[i];
    materials.push_back({{"name", report.material_names[i]},
                         {"receiving", coefficients_json(needs.receiving)},
                         {"emitting", coefficients_json(needs.emitting)}});
  }
  const PlanFigures& plan = *report.plan;
  const auto hits = static_cast<double>(std::max<std::size_t>(plan.hits, 1));
  nlohmann::json json{{"materials", materials},
                      {"horizon", name_of(horizon_names, report.options.horizon)},
                      {"coefficient_bits", report.scene_plan->coefficient_bits},
                      {"half_error", report.scene_plan->half_error},
                      {"emission_bands", report.scene_plan->emission_bands},
                      {"groups", plan.groups},
                      {"lights_per_hit", plan.cut_lights / hits},
                      {"lights_per_hit_not_dark", plan.pairs / hits},
                      {"light_bytes", {{"planned", report.light_bytes.planned}, {"full", report.light_bytes.full}}},
                      {"table_bytes", {{"planned", report.table_bytes.planned}, {"full", report.table_bytes.full}}},
                      {"proved_error", plan.proved_error()},
                      {"checked_hits", plan.checked}};
  if (plan.checked > 0) {
    json["measured_error"] = plan.measured_error();
    json["full_gather_seconds"] = full_gather_seconds(report);
  }
  return json;
}

}  // namespace

std::string json_text(const Report& report) {
  nlohmann::json json =
      report_json(options_json(report.options), counts_json(report.counts), report.machine, report.times);
  if (report.options.needs_lights()) {
    json["material_projection_error"] = report.material_error;
    json["gather_ns_per_hit_and_light"] = nanoseconds_per_gather(report);
  }
  if (report.plan) json["plan"] = plan_json(report);
  if (report.options.time_budget) json["time_budget"] = budget_json(report);
  if (report.errors) json["errors"] = errors_json(*report.errors);
  if (report.options.comparing()) {
    const std::string method = name_of(method_names, report.options.method);
    json["difference_map"] = {{"quantity", "display luma, " + method + " minus reference"},
                              {"red", method + " is brighter"},
                              {"blue", method + " is darker"},
                              {"saturates_at", difference_full_scale}};
  }
  return file_text(json);
}

}  // namespace example::hvl_render
