#include "report.hpp"

#include "shared/text_table.hpp"

namespace example::field_render {

std::string table(const Report& report) {
  std::vector<Row> rows{{"", "seconds"}};
  for (const auto& [stage, seconds] : report.times.stages()) rows.push_back({stage, seconds_text(seconds)});
  std::string text = align(rows);
  text += format("Grid of %d x %d x %d vertices, %d bands.\n", report.resolution.x, report.resolution.y,
                 report.resolution.z, report.grid_bands);
  if (report.errors) {
    text += "RMSE " + number_text("%.4f", report.errors->rmse) + ", RMSE / mean " +
            number_text("%.4f", report.errors->linear_rmse) + ", PSNR " + number_text("%.2f", report.errors->psnr) +
            " dB.\n";
  }
  return text;
}

}  // namespace example::field_render
