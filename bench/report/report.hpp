// The data of docs/report, as CSV on standard output; scripts/report.py makes tables and plots of it.
#pragma once

#include <cstddef>
#include <iostream>

namespace zonal_report {

/// quick: numbers that show that all is there. brief: minutes in all. full: what the report is best made of.
enum class Effort { quick, brief, full };

template <class T>
T choose(Effort effort, const T& quick, const T& brief, const T& full) {
  return effort == Effort::quick ? quick : effort == Effort::brief ? brief : full;
}

/// One line of CSV. No field needs quoting.
template <class First, class... Rest>
void print_row(const First& first, const Rest&... rest) {
  std::cout << first;
  ((std::cout << ',' << rest), ...);
  std::cout << std::endl;
}

void print_evaluation(Effort effort);
void print_interpolation(Effort effort);
void print_triangles(Effort effort);
void print_materials(Effort effort);
void print_furnace(Effort effort);
void print_stiff(Effort effort);
void print_probe(Effort effort);
void print_machine();

/// Writes three materials, made of models, in the format of the MERL database: FOLDER/NAME.binary.
void write_merl_files(const char* folder);

}  // namespace zonal_report
