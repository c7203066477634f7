#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace example {

/// One statement of an OBJ or MTL file: a line, or several that backslashes join. Valid until the next is read.
struct Statement {
  int line;                  // where it begins, from 1
  std::string_view keyword;  // never empty
  std::string_view rest;     // without blanks at its ends; may hold a comment
};

/// The statements of an OBJ or MTL file, whatever its line ends, with or without a byte order mark. Throws InputError
/// for a file that cannot be read, or that is UTF-16.
class Statements {
 public:
  explicit Statements(const std::filesystem::path& path);

  std::optional<Statement> next();

 private:
  std::string_view next_line();

  std::string text_;
  std::size_t place_ = 0;
  int line_ = 0;
  std::string joined_;
};

std::string_view without_blanks(std::string_view text);

/// Takes the next word off the text; empty at its end.
std::string_view next_word(std::string_view& text);

/// For numbers and indices: all before a '#'.
std::string_view without_comment(std::string_view text);

/// For names, which may hold a '#' themselves: all before a '#' that stands after a blank.
std::string_view name_without_comment(std::string_view text);

/// The whole word as one finite number, with or without a sign.
std::optional<double> number_in(std::string_view word);

/// For messages: a, b, c and 4 more.
std::string listed(const std::set<std::string>& names);

}  // namespace example
