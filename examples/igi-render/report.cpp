#include "report.hpp"

#include "shared/text_table.hpp"

namespace example::igi_render {
namespace {

std::string milliseconds(double seconds) { return format("%.1f", 1e3 * seconds); }

std::size_t positions(const Report& report) { return report.counts.primary_samples; }

Row cells(const Report& report, const Pass& pass) {
  const bool filtered = pass.numbers > 0;
  return {pass.name,
          filtered ? std::to_string(pass.numbers) : "-",
          filtered ? format("%.0f", static_cast<double>(pass.bytes) / static_cast<double>(positions(report))) : "-",
          milliseconds(pass.light_seconds),
          filtered ? milliseconds(pass.filter_seconds) : "-",
          filtered ? milliseconds(pass.shading_seconds) : "-"};
}

}  // namespace

std::string table(const Report& report) {
  Row titles{"", "numbers", "bytes", "light, ms", "filter, ms", "shading, ms"};
  if (report.reference) titles.insert(titles.end(), {"RMSE", "RMSE / mean", "PSNR, dB"});
  std::vector<Row> rows{titles};
  for (const Pass& pass : report.passes) {
    Row row = cells(report, pass);
    if (report.reference) {
      row.insert(row.end(), {number_text("%.4f", pass.errors.rmse), number_text("%.4f", pass.errors.linear_rmse),
                             number_text("%.2f", pass.errors.psnr)});
    }
    rows.push_back(std::move(row));
  }
  if (report.reference) {
    Row row = cells(report, report.reference->exact);
    row.insert(row.end(), {"-", "-", "-"});
    rows.push_back(std::move(row));
  }
  std::string text = align(rows);
  const double surface = static_cast<double>(report.counts.surface_bytes) / static_cast<double>(positions(report));
  text += format("%dx%d sets, %zu lights in all; %.0f bytes a position for the surface.\n",
                 report.options.pattern.columns, report.options.pattern.rows, report.counts.lights, surface);
  if (report.reference) {
    const ImageErrors& errors = report.reference->truncated.errors;
    text += format("Of %d bands alone, nothing filtered: RMSE %.4f, RMSE / mean %.4f.\n", report.options.bands,
                   errors.rmse, errors.linear_rmse);
  }
  return text;
}

}  // namespace example::igi_render
