// Numbers as text and back, whatever the locale. std::from_chars and std::to_chars of floats where the library has
// them: libstdc++ before 11, libc++ for long and macOS before 13.3 have none, and get the same from streams.
#pragma once

#include <charconv>
#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "../scalar/target.hpp"

#if defined(__cpp_lib_to_chars) && !defined(ZONAL_NO_FLOAT_CHARCONV)
#define ZONAL_HAS_FLOAT_CHARCONV 1
#else
#define ZONAL_HAS_FLOAT_CHARCONV 0
#endif

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// std::from_chars of a whole text, by a stream. One difference: what is too small for a Number may be 0 here.
template <class Number>
bool parse_by_stream(std::string_view text, Number& number) {
  // Streams take a sign and blanks in front, and hexadecimal digits; and infinity they do not know.
  if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string_view::npos || text[0] == '+') {
    return false;
  }
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  Number parsed{};
  if (!(stream >> parsed) || stream.peek() != std::istringstream::traits_type::eof()) return false;
  number = parsed;
  return true;
}

template <class Number>
std::string text_by_stream(Number number, std::ios_base::fmtflags format, int digits) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.setf(format, std::ios_base::floatfield);
  stream.precision(digits);
  stream << number;
  return stream.str();
}

// std::to_chars without a format, of a finite number: the fewest digits that read back to it, in the shorter notation.
template <class Number>
std::string shortest_by_stream(Number number) {
  std::string scientific;
  int decimals = 0;
  for (Number back{};; ++decimals) {
    scientific = text_by_stream(number, std::ios_base::scientific, decimals);
    if (decimals >= 20 || (parse_by_stream(scientific, back) && back == number)) break;
  }
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const int fixed_decimals = decimals > exponent ? decimals - exponent : 0;
  const std::string fixed = text_by_stream(number, std::ios_base::fixed, fixed_decimals);
  return scientific.size() < fixed.size() ? scientific : fixed;
}

}  // namespace detail

/// The whole text as one number, without blanks or a plus in front; false, and `number` as it was, where it is none, or
/// beyond what a Number holds. Infinities and NaN may be refused.
template <class Number>
bool parse_number(std::string_view text, Number& number) {
#if !ZONAL_HAS_FLOAT_CHARCONV
  if constexpr (std::is_floating_point_v<Number>) return detail::parse_by_stream(text, number);
#endif
  if constexpr (ZONAL_HAS_FLOAT_CHARCONV || !std::is_floating_point_v<Number>) {
    const char* end = text.data() + text.size();
    Number parsed{};
    const auto [stop, error] = std::from_chars(text.data(), end, parsed);
    if (error != std::errc() || stop != end || text.empty()) return false;
    number = parsed;
  }
  return true;
}

/// The shortest decimal that reads back to the same number, which is finite.
inline std::string shortest_text(float number) {
#if ZONAL_HAS_FLOAT_CHARCONV
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, number);
  return {digits, end.ptr};
#else
  return detail::shortest_by_stream(number);
#endif
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
