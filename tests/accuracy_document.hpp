// How docs/accuracy.md says what accuracy_table.hpp promises.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "accuracy_table.hpp"

/// The rows of a kernel, an entry of the registry's form, among these promises; none where there is none for it.
template <class Entry, class Promises>
std::string accuracy_rows(const Promises& promises) {
  std::ostringstream text;
  std::string summary;
  for (const char c : std::string_view(Entry::summary)) summary += c == '|' ? "\\|" : std::string(1, c);
  for (const Accuracy& row : promises) {
    if (row.kernel != Entry::name) continue;
    text << "| `" << row.kernel << "` | " << summary << " | " << row.scalar << " | "
         << (Entry::has_bands ? std::to_string(row.bands) : "") << " | " << row.range << " | " << row.bound << " | "
         << row.unit << " |\n";
    summary = "";  // once
  }
  return text.str();
}
