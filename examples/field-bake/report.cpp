#include "report.hpp"

#include <sys/resource.h>

#include "shared/report_json.hpp"
#include "shared/text_table.hpp"

namespace example::field_bake {
namespace {

std::string size_text(const glm::ivec3& size) { return format("%d x %d x %d", size.x, size.y, size.z); }

}  // namespace

std::size_t peak_memory() {
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::size_t>(usage.ru_maxrss) * 1024 : 0;
}

std::string text(const Report& report) {
  const Options& options = report.options;
  std::string text = format("%zu probes", report.probes);
  if (report.thinned > 0) text += format(", of which %zu tell nothing new", report.thinned);
  text += format("; %zu directions; %s points, %d bands%s.\n", report.buckets, size_text(options.resolution).c_str(),
                 options.bands, options.gradients ? " with gradients" : "");
  const std::size_t faults = report.faults.total();
  if (faults > 0) {
    text += format("%zu numbers in the pictures are no radiance: they count as not seen.\n", faults);
  }
  std::vector<Row> rows;
  for (const auto& [stage, seconds] : report.times.stages()) rows.push_back({stage, seconds_text(seconds) + " s"});
  text += align(rows);
  text += format("%s: %.1f MB; memory at most %.1f MB.\n", options.out.c_str(), double(report.grid_bytes) / 1e6,
                 double(peak_memory()) / 1e6);
  return text;
}

std::string json_text(const Report& report) {
  const Options& o = report.options;
  const auto point = [](const glm::vec3& p) { return nlohmann::json{p.x, p.y, p.z}; };
  const nlohmann::json options = {{"sequence", o.sequence},
                                  {"resolution", {o.resolution.x, o.resolution.y, o.resolution.z}},
                                  {"box", {point(report.box.lower), point(report.box.upper)}},
                                  {"bands", o.bands},
                                  {"gradients", o.gradients},
                                  {"path", o.path == Path::plane ? "plane" : "space"},
                                  {"slope_damping", number_or_null(double(o.resampling.slope_damping))},
                                  {"repair", o.resampling.repair == zonal::Repair::mip_maps ? "mip-maps" : "nearest"},
                                  {"thinning", o.thinning ? nlohmann::json(o.thinning->difference) : nlohmann::json()},
                                  {"memory_mib", o.memory}};
  const nlohmann::json counts = {{"probes", report.probes},
                                 {"thinned", report.thinned},
                                 {"buckets", report.buckets},
                                 {"pictures_read", report.pictures_read},
                                 {"blocks", report.blocks},
                                 {"blocks_done", report.blocks_done},
                                 {"ranks", report.ranks},
                                 {"grid_bytes", report.grid_bytes},
                                 {"peak_memory_bytes", peak_memory()},
                                 {"faults",
                                  {{"not_a_number", report.faults.not_a_number},
                                   {"infinite", report.faults.infinite},
                                   {"negative", report.faults.negative}}}};
  return file_text(report_json(options, counts, report.machine, report.times));
}

}  // namespace example::field_bake
