#include "report.hpp"

#include <cmath>

#include "shared/text_table.hpp"

namespace example::grid_render {
namespace {

std::string resolution_text(const glm::ivec3& resolution) {
  return format("%dx%dx%d", resolution.x, resolution.y, resolution.z);
}

Row row_of(const Pass& pass, const Pass& first) {
  Row row{pass.name};
  row.push_back(pass.grid ? resolution_text(pass.grid->resolution) : "-");
  row.push_back(pass.grid ? format("%.2f", static_cast<double>(pass.grid->bytes) / 1048576.0) : "-");
  row.push_back(pass.grid ? format("%.2f", 1e3 * pass.grid->seconds) : "-");
  row.push_back(format("%.1f", 1e3 * pass.seconds));
  if (!pass.errors) return row;
  row.push_back(format("%.1f", first.total() / pass.total()));
  row.push_back(format("%.3f", 1e3 * pass.errors->mae));
  row.push_back(format("%.3f", 1e3 * pass.errors->linear_mae));
  row.push_back(format("%.2f", pass.errors->psnr));
  return row;
}

}  // namespace

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
  std::vector<Row> rows{{"", "grid", "MiB", "grid, ms", "shading, ms"}};
  const bool comparing = report.options.comparing();
  if (comparing) rows[0].insert(rows[0].end(), {"speed-up", "MAE, 1e-3", "MAE / mean, 1e-3", "PSNR, dB"});
  for (const Pass& pass : report.passes) {
    Row row = row_of(pass, report.passes.front());
    row.resize(rows[0].size(), "-");
    rows.push_back(row);
  }
  std::string text = align(rows);
  text += format("%zu lights, %d bands, lobes %d; %zu points shaded; no shadows.\n", report.counts.lights,
                 report.options.bands, report.options.lobe_bands, report.counts.primary_hits);
  if (comparing) {
    text += format("MAE: of display values, and of radiance; pictures of differences: display values x %.0f.\n",
                   static_cast<double>(difference_factor));
    text += format("Values alone would have some %.1f vertices on an axis in the time of values and gradients.\n",
                   equal_time_resolution(report));
  }
  return text;
}

}  // namespace example::grid_render
