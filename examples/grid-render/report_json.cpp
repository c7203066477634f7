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
               {"grid", vector_json(options.grid)},
               {"bands", options.bands},
               {"lobe_bands", options.lobe_bands},
               {"window", name_of(window_names, options.window)}});
  return json;
}

nlohmann::json counts_json(const Counts& counts) {
  return {{"triangles", counts.triangles},
          {"materials", counts.materials},
          {"lights", counts.lights},
          {"primary_samples", counts.primary_samples},
          {"primary_hits", counts.primary_hits},
          {"pixels_not_finite", counts.pixels_not_finite}};
}

nlohmann::json errors_json(const ImageErrors& errors, const ImageErrors& trilinear) {
  return {{"mae", number_or_null(errors.mae)},
          {"mae_over_trilinear", number_or_null(errors.mae / trilinear.mae)},
          {"rmse", number_or_null(errors.rmse)},
          {"psnr_db", number_or_null(errors.psnr)},
          {"ssim", number_or_null(errors.ssim)},
          {"linear_mae_relative_to_mean", number_or_null(errors.linear_mae)},
          {"linear_mae_relative_to_mean_over_trilinear", number_or_null(errors.linear_mae / trilinear.linear_mae)},
          {"linear_rmse_relative_to_mean", number_or_null(errors.linear_rmse)}};
}

/// Comparing, the first two passes are the reference and the trilinear one.
nlohmann::json pass_json(const Pass& pass, const std::vector<Pass>& passes) {
  nlohmann::json json{{"interpolation", name_of(method_names, pass.method)}, {"shading_seconds", pass.seconds}};
  if (pass.grid) {
    json["grid"] = {{"resolution", vector_json(pass.grid->resolution)},
                    {"bytes", pass.grid->bytes},
                    {"seconds", pass.grid->seconds}};
  }
  if (pass.errors) {
    json["errors"] = errors_json(*pass.errors, *passes[1].errors);
    json["speed_up"] = number_or_null(passes[0].total() / pass.total());
  }
  return json;
}

}  // namespace

std::string json_text(const Report& report) {
  nlohmann::json json =
      report_json(options_json(report.options), counts_json(report.counts), report.machine, report.times);
  json["box"] = {{"lower", vector_json(report.box.lower)}, {"upper", vector_json(report.box.upper)}};
  for (const Pass& pass : report.passes) json["passes"][pass.name] = pass_json(pass, report.passes);
  if (report.options.comparing()) {
    json["equal_time_resolution"] = number_or_null(equal_time_resolution(report));
    json["difference_pictures"] = {{"quantity", "absolute difference of display values"},
                                   {"factor", difference_factor}};
  }
  return file_text(json);
}

}  // namespace example::grid_render
