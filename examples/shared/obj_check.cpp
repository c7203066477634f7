#include "obj_check.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string_view>

#include <zonal/file/number_text.hpp>

#include "input_error.hpp"

namespace example {
namespace {

// The square of a triangle's area must be a float.
constexpr double greatest_coordinate = 1e8;

/// Takes the next word off the line; empty at its end.
std::string_view next_word(std::string_view& line) {
  constexpr std::string_view blanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

bool is_coordinate(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  // Not a number fails the comparison.
  return zonal::parse_number(word, value) && std::abs(value) <= greatest_coordinate;
}

bool is_vertex(std::string_view words) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_coordinate(next_word(words))) return false;
  }
  return true;
}

}  // namespace

std::string check_obj(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read");
  std::string material_file;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::string_view words = line;
    const std::string_view keyword = next_word(words);
    if (keyword == "v" && !is_vertex(words)) {
      throw InputError(path + ":" + std::to_string(number) + ": not three finite coordinates up to 1e8");
    }
    if (keyword == "mtllib" && material_file.empty()) material_file = next_word(words);
  }
  return material_file;
}

}  // namespace example
