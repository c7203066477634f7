#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace example {

/// --help for terminals of 80 columns: options to the left, what they do wrapped to the right of them.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string type = option->get_type_name();
    std::string left = "  " + make_option_name(option, is_positional) + (type.empty() ? "" : " " + type);
    std::string help = option->get_description();
    if (!option->get_default_str().empty()) help += " [" + option->get_default_str() + "]";
    left += left.size() < text_column ? std::string(text_column - left.size(), ' ') : line_break();
    return left + wrapped(help) + "\n";
  }

 private:
  static constexpr std::size_t text_column = 33;
  static constexpr std::size_t text_width = 80 - text_column;

  static std::string line_break() { return "\n" + std::string(text_column, ' '); }

  static std::string wrapped(std::string text) {
    std::string lines;
    while (text.size() > text_width) {
      const std::size_t blank = text.rfind(' ', text_width);
      const bool is_one_word = blank == std::string::npos;
      const std::size_t end = is_one_word ? text_width : blank;
      lines += text.substr(0, end) + line_break();
      text.erase(0, is_one_word ? end : end + 1);
    }
    return lines + text;
  }
};

}  // namespace example
