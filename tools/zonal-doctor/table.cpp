#include "table.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <zonal/file/number_text.hpp>

namespace zonal_doctor {

namespace {

using Row = std::vector<double>;

std::optional<double> number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  if (zonal::parse_number(word, value)) return value;
  // As languages print them.
  std::string lower;
  for (const char c : word) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (lower == "nan" || lower == "-nan" || lower == "nan(ind)" || lower == "-nan(ind)") return std::nan("");
  if (lower == "inf" || lower == "infinity") return HUGE_VAL;
  if (lower == "-inf" || lower == "-infinity") return -HUGE_VAL;
  return std::nullopt;
}

// The numbers of a line, or the word that is none.
Row numbers_of(std::string_view line, std::string& bad_word) {
  Row row;
  constexpr std::string_view separators = " \t\r,;";
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find_first_not_of(separators); at != std::string_view::npos;
       at = line.find_first_not_of(separators, at)) {
    const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
    const std::string_view word = line.substr(at, end - at);
    const std::optional<double> value = number(word);
    if (!value) {
      bad_word = word;
      return {};
    }
    row.push_back(*value);
    at = end;
  }
  return row;
}

int root_of(std::size_t count) {
  const int root = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  return static_cast<std::size_t>(root) * static_cast<std::size_t>(root) == count ? root : 0;
}

std::string line_text(const std::string& name, std::size_t line) { return name + ": line " + std::to_string(line); }

}  // namespace

std::string read_text(const std::string& name) {
  if (name == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  if (std::filesystem::is_directory(name)) throw InputError(name + ": is a directory");
  errno = 0;
  std::ifstream file(name, std::ios::binary);
  if (!file) throw InputError(name + ": " + std::generic_category().message(errno));
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw InputError(name + ": cannot be read");
  return text.str();
}

Table parse_table(const std::string& name, const std::string& text, int bands) {
  std::vector<Row> rows;
  std::vector<std::size_t> lines;
  std::size_t line = 0;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string bad_word;
    Row row = numbers_of(std::string_view(text).substr(at, end - at), bad_word);
    at = end + 1;
    if (!bad_word.empty()) {
      if (rows.empty() && line == 0) continue;  // a heading
      throw InputError(line_text(name, line + 1) + ": '" + bad_word.substr(0, 40) + "' is no number");
    }
    if (row.empty()) continue;
    if (!rows.empty() && row.size() != rows.front().size()) {
      throw InputError(line_text(name, line + 1) + " has " + std::to_string(row.size()) + " numbers, line " +
                       std::to_string(lines.front()) + " " + std::to_string(rows.front().size()));
    }
    rows.push_back(std::move(row));
    lines.push_back(line + 1);
  }
  if (rows.empty()) throw InputError(name + ": has no numbers");
  const std::size_t columns = rows.front().size();
  const int with_directions = columns > 3 ? root_of(columns - 3) : 0, alone = root_of(columns);
  Table table;
  const auto is_wanted = [bands](int found) { return found > 0 && (bands == 0 || found == bands); };
  // 4 columns are one band with directions, or two alone: by the number of rows.
  const bool is_alone =
      is_wanted(alone) && (!is_wanted(with_directions) || rows.size() == zonal::diagnosis_directions(alone).size());
  table.bands = is_alone ? alone : is_wanted(with_directions) ? with_directions : 0;
  if (table.bands == 0) {
    throw InputError(name + ": has " + std::to_string(columns) + " columns, which is neither a direction and " +
                     (bands > 0 ? std::to_string(bands * bands) : std::string("N*N")) + " values nor these alone");
  }
  if (table.bands > 20) throw InputError(name + ": has " + std::to_string(table.bands) + " bands; 20 are the most");
  if (is_alone) {
    table.directions = zonal::diagnosis_directions(table.bands);
    if (rows.size() != table.directions.size()) {
      throw InputError(name + ": has " + std::to_string(rows.size()) + " lines of values, and --directions prints " +
                       std::to_string(table.directions.size()) + " directions for " + std::to_string(table.bands) +
                       " bands");
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (!is_alone) {
      const double length = std::hypot(row[0], row[1], row[2]);
      if (!(std::abs(length - 1) < 1e-3)) throw InputError(line_text(name, lines[i]) + ": is no unit vector x, y, z");
      table.directions.push_back({row[0], row[1], row[2]});
    }
    table.values.insert(table.values.end(), row.begin() + (is_alone ? 0 : 3), row.end());
  }
  return table;
}

}  // namespace zonal_doctor
