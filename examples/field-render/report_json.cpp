#include "shared/report_json.hpp"
#include "option_names.hpp"
#include "report.hpp"

namespace example::field_render {

std::string json_text(const Report& report) {
  const Options& options = report.options;
  nlohmann::json chosen = common_options_json(options);
  nlohmann::json materials = nlohmann::json::array();
  for (const MaterialChange& change : options.materials) materials.push_back(change.name + "=" + change.spec);
  chosen.update({{"view", camera_json(options.camera)},
                 {"grid", options.grid},
                 {"object", options.object},
                 {"materials", materials},
                 {"interpolation", name_of(interpolation_names, options.interpolation)},
                 {"bands", options.bands},
                 {"window", name_of(window_names, options.window)},
                 {"reference", options.reference ? name_of(field_setup_names, *options.reference) : ""},
                 {"samples", options.samples},
                 {"bounces", options.bounces},
                 {"seed", options.seed}});
  nlohmann::json json = report_json(chosen, counts_json(report.counts), report.machine, report.times);
  const auto point = [](const glm::vec3& p) { return nlohmann::json{p.x, p.y, p.z}; };
  json["grid"] = {{"resolution", {report.resolution.x, report.resolution.y, report.resolution.z}},
                  {"bands", report.grid_bands},
                  {"low", point(report.box.lower)},
                  {"high", point(report.box.upper)}};
  if (report.errors) json["errors"] = errors_json(*report.errors);
  return file_text(json);
}

}  // namespace example::field_render
