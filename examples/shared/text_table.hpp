#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace example {

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

inline std::string seconds_text(double seconds) { return format("%.3f", seconds); }

/// A dash for what is no number, as the error of a black picture relative to its mean.
inline std::string number_text(const char* pattern, double value) {
  return std::isfinite(value) ? format(pattern, value) : "-";
}

/// One line of a table: its name, then a cell for each column.
using Row = std::vector<std::string>;

/// Columns as wide as their widest cell, names to the left, cells to the right.
std::string align(const std::vector<Row>& rows);

}  // namespace example
