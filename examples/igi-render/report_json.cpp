#include "shared/report_json.hpp"
#include "option_names.hpp"
#include "report.hpp"

namespace example::igi_render {
namespace {

nlohmann::json options_json(const Options& options) {
  nlohmann::json json = common_options_json(options);
  json.update({{"view", camera_json(options.camera)},
               {"filter", options.comparing() ? "all" : name_of(filter_names, options.filter)},
               {"pattern", {options.pattern.columns, options.pattern.rows}},
               {"bands", options.bands},
               {"window", name_of(window_names, options.window)},
               {"bits", options.half ? 16 : 32},
               {"cos_normal", options.tests.cos_normal},
               {"plane_distance", options.tests.plane_distance},
               {"lighting", name_of(lighting_names, options.lighting)},
               {"probe", options.probe},
               {"samples_per_set", options.samples},
               {"bounces", options.bounces},
               {"least_distance", options.least_distance},
               {"seed", options.seed}});
  return json;
}

nlohmann::json pass_json(const Report& report, const Pass& pass) {
  nlohmann::json json{{"name", pass.name},
                      {"light_seconds", pass.light_seconds},
                      {"filter_seconds", pass.filter_seconds},
                      {"shading_seconds", pass.shading_seconds}};
  if (pass.numbers > 0) json.update({{"numbers", pass.numbers}, {"bytes", pass.bytes}});
  if (report.reference && pass.numbers > 0) json["errors"] = errors_json(pass.errors);
  return json;
}

}  // namespace

std::string json_text(const Report& report) {
  nlohmann::json counts = counts_json(report.counts);
  counts.update({{"lights", report.counts.lights}, {"surface_bytes", report.counts.surface_bytes}});
  nlohmann::json json = report_json(options_json(report.options), counts, report.machine, report.times);
  json["passes"] = nlohmann::json::array();
  for (const Pass& pass : report.passes) json["passes"].push_back(pass_json(report, pass));
  if (report.reference) {
    json["reference"] = pass_json(report, report.reference->exact);
    json["truncation"] = errors_json(report.reference->truncated.errors);
  }
  return file_text(json);
}

}  // namespace example::igi_render
