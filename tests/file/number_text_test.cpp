// Numbers as text without std::from_chars and std::to_chars of floats, against these.
#include <zonal/file/number_text.hpp>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "../catch.hpp"

#if ZONAL_HAS_FLOAT_CHARCONV

namespace {

std::string by_to_chars(float number) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, number);
  return {digits, end.ptr};
}

template <class Number>
void check_parse(const std::string& text) {
  Number expected = 7, got = 7;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
  const bool is_number = error == std::errc() && stop == text.data() + text.size() && !text.empty();
  CAPTURE(text);
  REQUIRE(zonal::detail::parse_by_stream(text, got) == is_number);
  REQUIRE(got == (is_number ? expected : 7));
  got = 7;
  REQUIRE(zonal::parse_number(text, got) == is_number);
  REQUIRE(got == (is_number ? expected : 7));
}

}  // namespace

TEST_CASE("number text: by streams it is what to_chars writes, for floats of any bits and for round ones") {
  std::mt19937 engine(5);
  std::vector<float> numbers{0.0F, -0.0F, 1.0F, 1e5F, 123456.0F, 1200.0F, 1e-5F, 0.0001F, 16777216.0F, 1234567936.0F};
  numbers.push_back(std::numeric_limits<float>::max());
  numbers.push_back(std::numeric_limits<float>::denorm_min());
  for (int i = 0; i < 4000; ++i) {
    const std::uint32_t bits = static_cast<std::uint32_t>(engine());
    float number;
    std::memcpy(&number, &bits, sizeof number);
    if (std::isfinite(number)) numbers.push_back(number);
    numbers.push_back(std::round(static_cast<float>(engine() % 1000000U)) / 1000.0F);
    numbers.push_back(static_cast<float>(engine()));
  }
  for (const float number : numbers) {
    CAPTURE(number);
    REQUIRE(zonal::detail::shortest_by_stream(number) == by_to_chars(number));
    REQUIRE(zonal::shortest_text(number) == by_to_chars(number));
  }
}

TEST_CASE("number text: by streams it is read as by from_chars, and refused as by it") {
  for (const char* text :
       {"",    " ",   "1",   "-1",    "+1",     " 1",  "1 ",  "1.",           ".5",   "-.5",     ".",
        "-",   "1e5", "1E5", "1e+5",  "1e",     "1e+", "e5",  "1.2.3",        "1,5",  "1.000,5", "0x10",
        "10x", "--1", "1-1", "1e400", "-1e400", "007", "0.1", "3.4028236e38", "1e39", "1e-40"}) {
    check_parse<double>(text);
    check_parse<float>(text);
  }
  std::mt19937 engine(6);
  const std::string letters = "0123456789.e-+";
  for (int i = 0; i < 4000; ++i) {
    std::string text;
    for (auto length = 1 + engine() % 7; length > 0; --length) text += letters[engine() % letters.size()];
    const std::size_t e = text.find('e');
    if (e != std::string::npos) text = text.substr(0, e + 4);  // no numbers that are too small
    check_parse<double>(text);
  }
}

#endif

TEST_CASE("number text: whole numbers are read whole") {
  int number = 7;
  for (const char* text : {"", "1.5", "+1", "12a", " 1", "99999999999"}) {
    CAPTURE(text);
    REQUIRE_FALSE(zonal::parse_number(text, number));
    REQUIRE(number == 7);
  }
  REQUIRE(zonal::parse_number("-12", number));
  REQUIRE(number == -12);
}
