// HVL Fig. 6: the operations of the zonal cap, and of what goes with it.
#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "tables.hpp"

namespace zonal_bench {
namespace {

constexpr int last_bands = 10;
constexpr int example_bands = 5;  // at which the kinds of operations are listed

struct Column {
  const char *title, *kernel, *argument;
};
constexpr std::array columns{Column{"evaluate", "evaluate", ""},
                             Column{"polynomial", "polynomial", ""},
                             Column{"orient", "orient", ""},
                             Column{"cap stable", "cap", ""},
                             Column{"cap Eq. 14", "cap_legendre", ""},
                             Column{"cap closed", "cap_closed_form", ""},
                             Column{"light", "gather_hvl_radiance", "/400"}};

void print_scalar(std::ostream& out, const Results& results, const std::string& scalar) {
  const auto result = [&](const Column& column, int bands) {
    return find(results, kernel_name(column.kernel, bands) + "/" + scalar + column.argument);
  };
  // Not every scalar gathers.
  const auto is_empty = [&](const Column& column) {
    for (int bands = 1; bands <= last_bands; ++bands) {
      if (result(column, bands) != nullptr) return false;
    }
    return true;
  };
  std::vector<Column> shown(columns.begin(), columns.end());
  shown.erase(std::remove_if(shown.begin(), shown.end(), is_empty), shown.end());
  if (shown.empty()) return;

  const Result* any = nullptr;
  for (int bands = 1; any == nullptr; ++bands) any = result(shown.front(), bands);
  out << "\n" << scalar << format(", lanes: %d\n     ", any->lanes);
  for (const Column& column : shown) out << format("%14s", column.title);
  out << "\nbands";
  for (std::size_t i = 0; i < shown.size(); ++i) out << format("%7s%7s", "ops", "ns");
  for (int bands = 1; bands <= last_bands; ++bands) {
    out << format("\n%5d", bands);
    for (const Column& column : shown) {
      const Result* r = result(column, bands);
      out << (r ? format("%7d%7.2f", r->operations(), r->median_ns()) : format("%7s%7s", "-", "-"));
    }
  }
  out << "\n";
}

void print_kinds(std::ostream& out, const Results& results) {
  const auto print = [&](const std::string& kernel, const Result& result) {
    out << format("%-34s", kernel.c_str());
    for (int count : result.counts) out << format("%6d", count);
    out << format("%7d", result.operations());
  };
  out << "\n" << format("%-34s", "kernel/bands");
  for (const char* kind : operation_counters) out << format("%6s", kind);
  out << "    ops";
  for (int lights : gather_lights) out << format("%7d", lights);
  out << " lights, ns per light\n";
  for (const Column& column : columns) {
    const std::string kernel = kernel_name(column.kernel, example_bands);
    if (const Result* r = find(results, kernel + "/float")) {
      print(kernel, *r);
      out << "\n";
    }
  }
  const std::string ending = "/packet/" + std::to_string(gather_lights.front());
  for (const auto& [name, result] : results) {
    const std::size_t end = name.find(ending);
    if (end == std::string::npos || end + ending.size() != name.size()) continue;
    const std::string kernel = name.substr(0, end);
    print(kernel, result);
    for (int lights : gather_lights) {
      const Result* r = find(results, kernel + "/packet/" + std::to_string(lights));
      out << (r ? format("%7.2f", r->median_ns()) : format("%7s", "-"));
    }
    out << "\n";
  }
}

// What the paper's text says of its figure, which it prints as a curve, without numbers.
void print_crossover(std::ostream& out, const Results& results) {
  int bands = last_bands;
  bool is_measured = false;
  for (; bands > 0; --bands) {
    const Result* closed_form = find(results, kernel_name("cap_closed_form", bands) + "/float");
    const Result* legendre = find(results, kernel_name("cap_legendre", bands) + "/float");
    if (closed_form == nullptr || legendre == nullptr) continue;
    is_measured = true;
    if (closed_form->operations() <= legendre->operations()) break;
  }
  if (!is_measured) return;
  out << "\nHVL 4.2: \"beyond 5 SH bands\" the closed forms take more operations than Eq. 14,\n"
         "z_l = sqrt(pi / (2l+1)) (P_(l-1) - P_(l+1)). Here: beyond "
      << bands << " bands.\n";
}

}  // namespace

void print_hvl_figure_6(std::ostream& out, const Results& results) {
  out << "HVL Fig. 6: operations, counted by the recorder, and ns per direction, cap or light, one thread\n";
  for (const char* scalar : {"float", "double", "packet"}) print_scalar(out, results, scalar);
  print_kinds(out, results);
  print_crossover(out, results);
}

}  // namespace zonal_bench
