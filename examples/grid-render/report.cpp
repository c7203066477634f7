#include "report.hpp"

#include <cmath>

#include "shared/text_table.hpp"

namespace example::grid_render {
namespace {

std::string resolution_text(const glm::ivec3& resolution) {
  return format("%dx%dx%d", resolution.x, resolution.y, resolution.z);
}

Row pass_cells(const Pass& pass) {
  return {pass.name, pass.grid ? resolution_text(pass.grid->resolution) : "-",
          pass.grid ? format("%.2f", static_cast<double>(pass.grid->bytes) / 1048576.0) : "-",
          pass.grid ? format("%.2f", 1e3 * pass.grid->seconds) : "-", format("%.1f", 1e3 * pass.seconds)};
}

Row error_cells(const ImageErrors& errors) {
  return {number_text("%.3f", 1e3 * errors.mae), number_text("%.3f", 1e3 * errors.linear_mae),
          number_text("%.2f", errors.psnr)};
}

const Row pass_titles{"", "grid", "MiB", "grid, ms", "shading, ms"};
const Row error_titles{"MAE, 1e-3", "MAE / mean, 1e-3", "PSNR, dB"};

Row joined(Row row, const Row& more) {
  row.insert(row.end(), more.begin(), more.end());
  return row;
}

std::string pass_table(const Report& report) {
  std::vector<Row> rows{pass_titles};
  for (const Pass& pass : report.passes) rows.push_back(pass_cells(pass));
  return align(rows);
}

/// Each pass against the first.
std::string interpolation_table(const Report& report) {
  std::vector<Row> rows{joined(joined(pass_titles, {"speed-up"}), error_titles)};
  const Pass& reference = report.passes.front();
  rows.push_back(joined(pass_cells(reference), {"-", "-", "-", "-"}));
  for (const Comparison& comparison : report.comparisons) {
    const Pass& pass = report.passes[comparison.picture];
    const Row speed_up{number_text("%.1f", reference.total() / pass.total())};
    rows.push_back(joined(joined(pass_cells(pass), speed_up), error_cells(comparison.errors)));
  }
  return align(rows);
}

/// Each pass against paths at every point.
std::string path_table(const Report& report) {
  std::vector<Row> rows{joined(joined(pass_titles, {"visibility, MiB"}), {"leak / mean, 1e-3", "MAE / mean, 1e-3"})};
  rows.push_back(joined(pass_cells(report.passes.front()), {"-", "-", "-"}));
  for (const Comparison& comparison : report.comparisons) {
    const Pass& pass = report.passes[comparison.picture];
    const std::size_t bytes = pass.grid ? pass.grid->visibility_bytes : 0;
    rows.push_back(joined(pass_cells(pass), {format("%.2f", static_cast<double>(bytes) / 1048576.0),
                                             number_text("%.3f", 1e3 * comparison.leak),
                                             number_text("%.3f", 1e3 * comparison.errors.linear_mae)}));
  }
  return align(rows);
}

std::string comparison_table(const Report& report) {
  std::vector<Row> rows{joined({"", "against"}, error_titles)};
  for (const Comparison& comparison : report.comparisons) {
    const Row names{report.passes[comparison.picture].name, report.passes[comparison.reference].name};
    rows.push_back(joined(names, error_cells(comparison.errors)));
  }
  return align(rows);
}

std::string mebibytes(std::size_t bytes) { return format("%.2f", static_cast<double>(bytes) / 1048576.0); }
std::string percent(double share) { return format("%.3g %%", 100.0 * share); }

/// What a tolerance led to, in a line.
std::string plan_line(const Report& report) {
  const GridPlan& plan = *report.plan;
  const std::string tolerance = "Tolerance " + percent(report.options.tolerance) + ": ";
  if (plan.choice.bands == 0) {
    return tolerance + "no grid within it takes less time than all lights at each point, which are taken.\n";
  }
  std::string text =
      tolerance + format("error predicted %s at %zu points", percent(plan.predicted_error).c_str(), plan.predicted_at);
  if (plan.measured_at > 0) {
    text += format(", measured %s at %zu others", percent(plan.measured_error).c_str(), plan.measured_at);
  }
  return text + ".\n";
}

/// The plan as tables that a person reads.
std::string explanation(const Report& report) {
  const Options& options = report.options;
  const GridPlan& plan = *report.plan;
  const Pass& pass = report.passes.front();
  const GridChoice& choice = plan.choice;
  const bool is_hermite = choice.method == zonal::Interpolation::hermite;
  std::vector<Row> choices{{"chosen", "", "why"}};
  if (choice.bands > 0) {
    choices.push_back({"grid", resolution_text(choice.resolution),
                       format("the cheapest of %zu grids looked at that is within the tolerance", plan.tried)});
    choices.push_back({"interpolation", is_hermite ? "hermite" : "trilinear",
                       is_hermite ? "values and gradients, of few vertices" : "values alone, of more vertices"});
    choices.push_back({"bands in the grid", format("%d of %d", choice.bands, options.bands),
                       choice.bands < options.bands ? "the materials ask for no more" : "the materials ask for them"});
    choices.push_back({"lights too near for it",
                       choice.near.is_empty() ? "none" : format("up to %.3g m", static_cast<double>(choice.near.to)),
                       choice.near.is_empty() ? "the grid tells of all"
                                              : format("%.1f at a point, one by one; the step begins at %.3g m",
                                                       plan.near_lights, static_cast<double>(choice.near.from))});
  }
  const double fill = pass.grid ? pass.grid->seconds : 0.0;
  const std::size_t planned = choice.bands > 0 ? pass.grid->bytes + plan.near_bytes : plan.light_bytes;
  const std::vector<Row> rows{
      {"", "all lights at each point", "planned"},
      {"plan, ms", "-", format("%.1f", 1e3 * report.times.seconds(stage_name::plan))},
      {"grid, ms", "-", format("%.1f", 1e3 * fill)},
      {"shading, ms", format("%.1f", 1e3 * plan.full_seconds), format("%.1f", 1e3 * pass.seconds)},
      {"lights in memory, MiB", mebibytes(plan.light_bytes), mebibytes(planned)},
      {"error, predicted", "0", percent(plan.predicted_error)},
      {"error, measured", "0", percent(plan.measured_error)},
  };
  std::string text = "\n";
  if (choices.size() > 1) text += align(choices) + "\n";
  return text + align(rows);
}

std::string tables(const Report& report) {
  if (!report.options.comparing()) return pass_table(report);
  if (report.options.paths > 0) return path_table(report);
  if (!report.options.comparing_shapes) return interpolation_table(report);
  return pass_table(report) + "\n" + comparison_table(report);
}

std::string lights_text(const Report& report) {
  const Options& options = report.options;
  return options.load_grid.empty() ? format("%zu lights", report.counts.lights) : "the grid of " + options.load_grid;
}

}  // namespace

double leak(const Image& picture, const Image& reference) {
  const auto brightness = [](const glm::vec3& c) { return static_cast<double>(c.r + c.g + c.b) / 3.0; };
  double mean = 0.0, squares = 0.0;
  for (const glm::vec3& pixel : reference.pixels) mean += brightness(pixel);
  mean /= static_cast<double>(reference.pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    if (!(brightness(reference.pixels[i]) < 1e-3 * mean)) continue;
    squares += std::pow(brightness(picture.pixels[i]), 2);
    ++count;
  }
  return std::sqrt(squares / static_cast<double>(count)) / mean;
}

double equal_time_resolution(const Report& report) {
  const Pass *gradients = nullptr, *values = nullptr;
  for (const Pass& pass : report.passes) {
    if (pass.grid && pass.grid->resolution == report.options.grid) gradients = &pass;
    if (pass.grid && pass.grid->resolution != report.options.grid) values = &pass;
  }
  if (gradients == nullptr || values == nullptr) return 0.0;
  const glm::ivec3& size = values->grid->resolution;
  const double vertices = static_cast<double>(size.x) * size.y * size.z;
  return std::cbrt(vertices * gradients->grid->seconds / values->grid->seconds);
}

std::string table(const Report& report) {
  const Options& options = report.options;
  std::string text = tables(report) + lights_text(report);
  text += format(", %d bands, lobes %d; %zu points shaded; ", options.bands, options.lobe_bands,
                 report.counts.primary_hits);
  text += options.paths > 0 ? format("%d paths each.\n", options.paths) : std::string("no shadows.\n");
  if (options.comparing() && options.paths > 0) {
    return text + "Leak: radiance, root mean square, where the reference is black.\n";
  }
  if (report.plan) text += plan_line(report);
  if (report.plan && options.explain) text += explanation(report);
  if (!options.comparing()) return text;
  text += format("MAE: of display values, and of radiance; pictures of differences: display values x %.0f.\n",
                 static_cast<double>(difference_factor));
  if (options.comparing_shapes) return text;
  return text + "Values alone would have some " + number_text("%.1f", equal_time_resolution(report)) +
         " vertices on an axis in the time of values and gradients.\n";
}

}  // namespace example::grid_render
