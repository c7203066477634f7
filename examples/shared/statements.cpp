#include "statements.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <zonal/file/number_text.hpp>

#include "input_error.hpp"

namespace example {
namespace {

constexpr std::string_view blanks = " \t\v\f";

}  // namespace

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string_view without_comment(std::string_view text) { return without_blanks(text.substr(0, text.find('#'))); }

std::string_view name_without_comment(std::string_view text) {
  for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1)) {
    if (i == 0 || blanks.find(text[i - 1]) != std::string_view::npos) return without_blanks(text.substr(0, i));
  }
  return without_blanks(text);
}

std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  if (!zonal::parse_number(word, value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

Statements::Statements(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path.string() + ": cannot be read");
  text_.assign(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) throw InputError(path.string() + ": cannot be read");
  if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
    throw InputError(path.string() + ": is UTF-16, not UTF-8");
  }
  if (text_.starts_with("\xEF\xBB\xBF")) place_ = 3;
}

std::string_view Statements::next_line() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", place_), text_.size());
  const std::string_view line = std::string_view(text_).substr(place_, end - place_);
  const bool two = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
  place_ = end + (two ? 2 : 1);
  ++line_;
  return without_blanks(line);
}

std::optional<Statement> Statements::next() {
  while (place_ < text_.size()) {
    std::string_view line = next_line();
    const int first_line = line_;
    // A comment may end in a path and its backslash; it goes on no further.
    if (line.ends_with('\\') && name_without_comment(line).size() == line.size()) {
      joined_.clear();
      for (; line.ends_with('\\') && place_ < text_.size(); line = next_line()) {
        joined_.append(line.substr(0, line.size() - 1)).append(" ");
      }
      joined_.append(line.ends_with('\\') ? line.substr(0, line.size() - 1) : line);
      line = joined_;
    }
    const std::string_view keyword = next_word(line);
    if (!keyword.empty() && keyword.front() != '#') return Statement{first_line, keyword, without_blanks(line)};
  }
  return std::nullopt;
}

std::string listed(const std::set<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (count < most) text += (text.empty() ? "" : ", ") + name;
    ++count;
  }
  return count > most ? text + " and " + std::to_string(count - most) + " more" : text;
}

}  // namespace example
