// zonal-report-data PART [--quick|--full]
//   evaluation, interpolation, triangles, materials, furnace, stiff, probe    that part's data, CSV on standard output
//   machine                                                     what it was measured on
// zonal-report-data merl FOLDER                                 writes files in MERL's format there
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

#include <zonal/file/standard_output.hpp>

#include "../machine.hpp"
#include "report.hpp"

namespace {

using zonal_report::Effort;

struct Part {
  const char* name;
  void (*print)(Effort);
};
constexpr Part parts[] = {
    {"evaluation", zonal_report::print_evaluation}, {"interpolation", zonal_report::print_interpolation},
    {"triangles", zonal_report::print_triangles},   {"materials", zonal_report::print_materials},
    {"furnace", zonal_report::print_furnace},       {"stiff", zonal_report::print_stiff},
    {"probe", zonal_report::print_probe},           {"machine", [](Effort) { zonal_report::print_machine(); }},
};

int usage() {
  std::fputs(
      "usage: zonal-report-data evaluation|interpolation|triangles|materials|furnace|stiff|probe|machine "
      "[--quick|--full]\n"
      "       zonal-report-data merl FOLDER\n",
      stderr);
  return 2;
}

int run(int argc, char** argv) {
  if (argc < 2 || argc > 3) return usage();
  const std::string part = argv[1], option = argc == 3 ? argv[2] : "";
  if (part == "merl" && argc == 3) {
    zonal_report::write_merl_files(argv[2]);
    return 0;
  }
  if (argc == 3 && option != "--quick" && option != "--full") return usage();
  const Effort effort = option == "--quick" ? Effort::quick : option == "--full" ? Effort::full : Effort::brief;
  for (const Part& known : parts) {
    if (part != known.name) continue;
    known.print(effort);
    return 0;
  }
  return usage();
}

}  // namespace

void zonal_report::print_machine() {
  print_row("fact", "value");
  std::string compiler = zonal_bench::compiler();
  for (char& c : compiler) c = c == ',' ? ';' : c;  // a field of CSV
  print_row("compiler", compiler);
  print_row("processor", zonal_bench::processor());
}

int main(int argc, char** argv) {
  try {
    return zonal::with_standard_output([&] { return run(argc, argv); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-report-data: %s\n", error.what());
    return 1;
  }
}
