// Tables of numbers as text: a row a line, separated by blanks, tabs, commas or semicolons; from # on a remark.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <zonal/convention/diagnose.hpp>

namespace zonal_doctor {

struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Table {
  int bands = 0;
  std::vector<zonal::Direction> directions;
  std::vector<double> values;
};

/// The file's text, or standard input's where the name is -. Throws InputError.
std::string read_text(const std::string& name);

/// x, y, z and N*N values a line; or N*N values alone, of the directions that --directions prints, in their order. A
/// first line of words is a heading. `bands` 0: as many as there are columns for. Throws InputError, which says which
/// line is none.
Table parse_table(const std::string& name, const std::string& text, int bands);

}  // namespace zonal_doctor
