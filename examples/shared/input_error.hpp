#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace example {

/// What the user gave cannot be used; `what()` is one line for the terminal.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws InputError unless there is a regular file at `path`.
void check_is_file(const std::filesystem::path& path);

/// The text with its line breaks turned into blanks: what libraries say, for an InputError.
std::string one_line(std::string text);

}  // namespace example
