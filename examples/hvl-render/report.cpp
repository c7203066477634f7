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

/// What a tolerance left out, and how far off that is, in a line.
std::string plan_line(const Report& report) {
  const PlanFigures& plan = *report.plan;
  const auto hits = static_cast<double>(std::max<std::size_t>(plan.hits, 1));
  std::string text = format("Tolerance %.3g %%: %.0f lights per hit in place of %zu; error at most %.3g %%",
                            100 * report.options.tolerance, plan.pairs / hits, report.counts.virtual_lights,
                            100 * plan.proved_error());
  if (plan.checked > 0) text += format(", measured %.3g %% at %zu hits", 100 * plan.measured_error(), plan.checked);
  return text + ".\n";
}

std::string coefficients_text(const zonal::CoefficientPlan& plan, int asked) {
  const char* const names[] = {"the same about the normal", "a mirror plane", "none"};
  const int kept = plan.kept_count();
  return format("%d of %d, ", kept, zonal::coefficient_count(zonal::Symmetry::none, asked)) +
         names[static_cast<int>(plan.symmetry)];
}

std::string bytes_text(std::size_t bytes) {
  const auto size = static_cast<double>(bytes);
  return size < 1e6 ? format("%.0f kB", size / 1e3) : format("%.1f MB", size / 1e6);
}

/// The plan as tables that a person reads.
std::string explanation(const Report& report) {
  const Options& options = report.options;
  std::vector<Row> materials{{"material", "coefficients kept, symmetry", "bands it sends", "error", "why"}};
  for (std::size_t i = 0; i < report.scene_plan->materials.size(); ++i) {
    const MaterialNeeds& needs = report.scene_plan->materials[i];
    const bool all = needs.receiving.symmetry != zonal::Symmetry::zonal && needs.emitting.bands > 1;
    materials.push_back({report.material_names[i], coefficients_text(needs.receiving, options.bands),
                         format("%d of %d", needs.emitting.bands, options.emission_bands),
                         format("%.1g %%", 100 * std::max(needs.receiving.error.mean, needs.emitting.error.mean)),
                         all ? "it needs them" : "the others are zero"});
  }
  const PlanFigures& plan = *report.plan;
  const auto hits = static_cast<double>(std::max<std::size_t>(plan.hits, 1));
  const double gather = report.times.seconds(stage_name::gather), full = full_gather_seconds(report);
  const auto percent = [](double share) { return format("%.3g %%", 100 * share); };
  const std::vector<Row> rows{
      {"", "in full", "planned"},
      {"lights per hit", std::to_string(report.counts.virtual_lights), format("%.0f", plan.cut_lights / hits)},
      {"of these not dark", "", format("%.0f", plan.pairs / hits)},
      {"bands of emission", std::to_string(options.emission_bands), std::to_string(report.scene_plan->emission_bands)},
      {"gather, s", full > 0.0 ? format("%.2f", full) : "-", format("%.2f", gather)},
      {"lights in memory", bytes_text(report.light_bytes.full), bytes_text(report.light_bytes.planned)},
      {"materials in memory", bytes_text(report.table_bytes.full), bytes_text(report.table_bytes.planned)},
      {"bits of a coefficient", "32", std::to_string(report.scene_plan->coefficient_bits)},
      {"error of 16 bits, at most", "0", percent(report.scene_plan->half_error)},
      {"error, proved", "0", percent(plan.proved_error())},
      {"error, measured", "0", plan.checked > 0 ? percent(plan.measured_error()) : "-"},
  };
  std::string text = "\n" + align(materials) + "\n" + align(rows);
  text += format("%zu groups of hits, each of one surface or of a few small ones. ", plan.groups);
  text += "Of each cluster of a cut one light is drawn, in proportion to what its lights send at most.\n";
  if (options.centre_visibility) text += "The bound holds whichever lights are hidden.\n";
  return text;
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

double full_gather_seconds(const Report& report) {
  return report.plan ? report.plan->full_seconds() / std::max(report.machine.threads, 1) : 0.0;
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
  if (report.plan) text += plan_line(report);
  if (report.plan && report.options.explain) text += explanation(report);
  if (report.options.comparing()) {
    text += format("Difference: red where %s is brighter, blue where darker; full at %.2f of luma.\n",
                   name_of(method_names, report.options.method).c_str(), static_cast<double>(difference_full_scale));
  }
  return text;
}

}  // namespace example::hvl_render
