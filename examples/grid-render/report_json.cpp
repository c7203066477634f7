#include "shared/report_json.hpp"
#include "option_names.hpp"
#include "report.hpp"

namespace example::grid_render {
namespace {

nlohmann::json vector_json(const glm::vec3& v) { return {v.x, v.y, v.z}; }
nlohmann::json vector_json(const glm::ivec3& v) { return {v.x, v.y, v.z}; }

nlohmann::json options_json(const Options& options) {
  nlohmann::json json = common_options_json(options);
  json.update({{"view", camera_json(options.camera)},
               {"interpolation", options.comparing() ? "compare" : name_of(method_names, options.method)},
               {"lights", options.lights},
               {"texture", options.texture},
               {"texture_size", options.texture_size},
               {"quadtree_error", options.quadtree_error ? nlohmann::json(*options.quadtree_error) : nlohmann::json()},
               {"shape", options.comparing_shapes ? "compare" : name_of(shape_names, options.shape)},
               {"grid", vector_json(options.grid)},
               {"save_grid", options.save_grid},
               {"load_grid", options.load_grid},
               {"bands", options.bands},
               {"lobe_bands", options.lobe_bands},
               {"paths", options.paths},
               {"visibility", options.is_visible},
               {"tolerance", options.tolerance},
               {"window", name_of(window_names, options.window)}});
  return json;
}

nlohmann::json counts_json(const Counts& counts) {
  nlohmann::json json = example::counts_json(counts);
  json.update({{"lights", counts.lights}});
  return json;
}

nlohmann::json pass_json(const Pass& pass) {
  nlohmann::json json{{"interpolation", name_of(method_names, pass.technique.method)},
                      {"shape", name_of(shape_names, pass.technique.shape)},
                      {"lights", pass.lights},
                      {"shading_seconds", pass.seconds}};
  if (pass.technique.is_zonal) json["interpolation"] = "zonal";
  if (pass.grid) {
    json["grid"] = {{"resolution", vector_json(pass.grid->resolution)},
                    {"bytes", pass.grid->bytes},
                    {"seconds", pass.grid->seconds},
                    {"visibility_bytes", pass.grid->visibility_bytes}};
  }
  return json;
}

nlohmann::json plan_json(const GridPlan& plan) {
  nlohmann::json json{{"grids_tried", plan.tried},
                      {"predicted_error", plan.predicted_error},
                      {"predicted_at_points", plan.predicted_at},
                      {"full_bytes", plan.light_bytes}};
  if (plan.measured_at > 0) {
    json.update({{"measured_error", plan.measured_error},
                 {"measured_at_points", plan.measured_at},
                 {"full_seconds", plan.full_seconds}});
  }
  if (plan.choice.bands > 0) {
    json.update({{"bands", plan.choice.bands},
                 {"near_range", {plan.choice.near.from, plan.choice.near.to}},
                 {"near_lights_per_point", plan.near_lights},
                 {"near_bytes", plan.near_bytes}});
  }
  return json;
}

/// Each pass's errors against the first, and beside those of the trilinear one, which comes next.
void add_errors(nlohmann::json& passes, const Report& report) {
  const ImageErrors& trilinear = report.comparisons.front().errors;
  for (const Comparison& comparison : report.comparisons) {
    const Pass& pass = report.passes[comparison.picture];
    const ImageErrors& errors = comparison.errors;
    nlohmann::json& json = passes[pass.name];
    json["errors"] = errors_json(errors);
    json["errors"]["mae_over_trilinear"] = number_or_null(errors.mae / trilinear.mae);
    json["errors"]["linear_mae_relative_to_mean_over_trilinear"] =
        number_or_null(errors.linear_mae / trilinear.linear_mae);
    if (report.options.paths > 0) json["leak"] = number_or_null(comparison.leak);
    json["speed_up"] = number_or_null(report.passes[comparison.reference].total() / pass.total());
  }
}

void add_comparisons(nlohmann::json& json, const Report& report) {
  for (const Comparison& comparison : report.comparisons) {
    json[comparison.name] = {{"picture", report.passes[comparison.picture].name},
                             {"reference", report.passes[comparison.reference].name},
                             {"errors", errors_json(comparison.errors)}};
  }
}

}  // namespace

std::string json_text(const Report& report) {
  nlohmann::json json =
      report_json(options_json(report.options), counts_json(report.counts), report.machine, report.times);
  json["box"] = {{"lower", vector_json(report.box.lower)}, {"upper", vector_json(report.box.upper)}};
  for (const Pass& pass : report.passes) json["passes"][pass.name] = pass_json(pass);
  if (report.plan) json["plan"] = plan_json(*report.plan);
  if (report.options.comparing_shapes) {
    add_comparisons(json["comparisons"], report);
  } else if (report.options.comparing()) {
    add_errors(json["passes"], report);
    if (report.options.paths == 0) json["equal_time_resolution"] = number_or_null(equal_time_resolution(report));
  }
  if (report.options.comparing()) {
    json["difference_pictures"] = {{"quantity", "absolute difference of display values"},
                                   {"factor", difference_factor}};
  }
  return file_text(json);
}

}  // namespace example::grid_render
