// How docs/accuracy.md says what zonal/accuracy.hpp promises.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "accuracy.hpp"

inline constexpr std::string_view accuracy_columns =
    "| function | room | what it gives | scalar | bands | range | greatest error | in units of | known by | worst "
    "found | ratio "
    "| at, and remarks |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

inline std::string accuracy_row(const Accuracy& row, std::string_view summary) {
  std::ostringstream text;
  text.precision(3);
  text << "| `" << row.function << "` | " << row.room << " | ";
  for (const char c : summary) text << (c == '|' ? "\\|" : std::string(1, c));
  text << " | " << row.scalar << " | " << (row.bands > 0 ? std::to_string(row.bands) : "") << " | " << row.range
       << " | " << row.bound;
  if (row.common > 0) text << " (" << row.common << ")";
  text << " | " << row.unit << " | "
       << (row.ground == zonal::Ground::proved        ? "proof"
           : row.ground == zonal::Ground::every_input ? "every input"
                                                      : "search")
       << " | ";
  if (row.worst > 0 || row.bound <= 0) text << row.worst;  // else none is kept
  text << " | ";
  if (row.worst > 0) {
    text.precision(2);
    text << row.bound / row.worst;
  }
  text << " | ";
  if (!row.worst_input.empty()) text << '`' << row.worst_input << '`' << (row.remark.empty() ? "" : "; ");
  text << row.remark << " |\n";
  return text.str();
}

/// The rows of a kernel, an entry of the registry's form, among these promises; none where there is none for it.
template <class Entry, class Promises>
std::string accuracy_rows(const Promises& promises) {
  std::string text;
  std::string_view summary = Entry::summary;
  for (const Accuracy& row : promises) {
    if (row.function != Entry::name) continue;
    text += accuracy_row(row, summary);
    summary = "";  // once
  }
  return text;
}
