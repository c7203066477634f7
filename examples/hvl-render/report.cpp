#include "report.hpp"

#include <algorithm>

#include "option_names.hpp"
#include "shared/text_table.hpp"

namespace example::hvl_render {
namespace {

/// What one method did; a dash where a line is not its own.
struct Column {
  std::string method = "-", samples = "-", bands = "-", scene = "-", materials = "-", lights = "-", primary = "-",
              direct = "-", indirect = "-", total = "-", rmse = "-", linear_rmse = "-", psnr = "-", ssim = "-",
              cost = "-";
};

/// The stages that both methods have, and the sum with the method's own.
void add_shared(Column& column, const StageTimes& times, double own_seconds) {
  const double scene = times.seconds(stage_name::scene);
  const double primary = times.seconds(stage_name::primary);
  const double direct = times.seconds(stage_name::direct);
  column.scene = seconds_text(scene);
  column.primary = seconds_text(primary);
  column.direct = seconds_text(direct);
  column.total = seconds_text(scene + primary + direct + own_seconds);
}

void add_errors(Column& column, const ImageErrors& errors) {
  column.rmse = number_text("%.4f", errors.rmse);
  column.linear_rmse = number_text("%.4f", errors.linear_rmse);
  column.psnr = number_text("%.2f", errors.psnr);
  column.ssim = number_text("%.4f", errors.ssim);
}

Column lights_column(const Report& report) {
  const StageTimes& times = report.times;
  const double materials = times.seconds(stage_name::materials);
  Column column;
  const Options& options = report.options;
  column.method = name_of(method_names, options.method);
  column.samples = std::to_string(report.counts.virtual_lights) + (options.blocks() ? " texels" : " lights");
  if (options.method == Method::vsl) column.samples += ", " + std::to_string(options.vsl_samples) + " samples";
  if (options.method == Method::hvl) {
    column.bands = std::to_string(options.bands) + ", emission " + std::to_string(options.emission_bands);
  }
  if (options.method == Method::hvl_zonal) column.bands = std::to_string(options.bands);
  if (materials > 0.001) column.materials = seconds_text(materials);
  column.lights = seconds_text(times.seconds(stage_name::lights));
  column.indirect = seconds_text(times.seconds(stage_name::gather));
  add_shared(column, times, materials + light_seconds(report));
  if (report.errors) add_errors(column, *report.errors);
  column.cost = format("%.2f", nanoseconds_per_gather(report));
  return column;
}

Column path_column(const Report& report) {
  const double paths = report.times.seconds(stage_name::paths);
  Column column;
  column.method = "path";
  column.samples = std::to_string(report.counts.samples_per_pixel) + " spp";
  column.indirect = seconds_text(paths);
  add_shared(column, report.times, paths);
  // In a comparison the paths are what the errors refer to.
  if (report.errors && !report.options.comparing()) add_errors(column, *report.errors);
  return column;
}

std::vector<Row> table_rows(const std::vector<Column>& columns) {
  using Cell = std::string Column::*;
  const std::vector<std::pair<const char*, Cell>> lines{
      {"method", &Column::method},
      {"samples", &Column::samples},
      {"bands", &Column::bands},
      {"scene and BVH, s", &Column::scene},
      {"material projection, s", &Column::materials},
      {"virtual lights, s", &Column::lights},
      {"primary rays, s", &Column::primary},
      {"direct light, s", &Column::direct},
      {"indirect light, s", &Column::indirect},
      {"total, s", &Column::total},
      {"RMSE, display", &Column::rmse},
      {"RMSE, radiance / mean", &Column::linear_rmse},
      {"PSNR, dB", &Column::psnr},
      {"SSIM", &Column::ssim},
      {"ns per hit and light", &Column::cost},
  };
  std::vector<Row> rows;
  for (const auto& [name, cell] : lines) {
    Row row{name};
    for (const Column& column : columns) row.push_back(column.*cell);
    const bool says_nothing = std::all_of(row.begin() + 1, row.end(), [](const auto& text) { return text == "-"; });
    if (!says_nothing) rows.push_back(std::move(row));
  }
  return rows;
}

/// What came of a time budget.
std::string budget_text(const Report& report) {
  const double given = *report.options.time_budget, took = light_seconds(report);
  if (report.options.lights == 1 && took > given) {
    return format("A time budget of %.3g s is too short: one light took %.3g s.\n", given, took);
  }
  return format("In a time budget of %.3g s, %d light%s took %.3g s.\n", given, report.options.lights,
                report.options.lights == 1 ? "" : "s", took);
}

}  // namespace

double nanoseconds_per_gather(const Report& report) {
  const double pairs =
      static_cast<double>(report.counts.primary_hits) * static_cast<double>(report.counts.virtual_lights);
  return pairs > 0.0 ? 1e9 * report.times.seconds(stage_name::gather) / pairs : 0.0;
}

double light_seconds(const Report& report) {
  return report.times.seconds(stage_name::lights) + report.times.seconds(stage_name::gather);
}

std::string table(const Report& report) {
  std::vector<Column> columns;
  if (report.options.needs_lights()) columns.push_back(lights_column(report));
  if (report.options.needs_paths()) columns.push_back(path_column(report));
  std::string text = align(table_rows(columns));
  const auto asked = static_cast<std::size_t>(report.options.lights);
  if (report.options.time_budget) {
    text += budget_text(report);
  } else if (report.options.needs_lights() && !report.options.blocks() && report.counts.map_lights != asked) {
    text += format("%zu lights were asked for: the map has %zu, the next square.\n", asked, report.counts.map_lights);
  }
  if (report.options.needs_lights() && report.counts.virtual_lights != report.counts.map_lights) {
    text += format("%zu of them carry no light.\n", report.counts.map_lights - report.counts.virtual_lights);
  }
  if (report.options.comparing()) {
    text += format("Difference: red where %s is brighter, blue where darker; full at %.2f of luma.\n",
                   name_of(method_names, report.options.method).c_str(), static_cast<double>(difference_full_scale));
  }
  return text;
}

}  // namespace example::hvl_render
