#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace example {

/// The whole text as one number.
template <class Number>
bool parse_number(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && !text.empty();
}

}  // namespace example
