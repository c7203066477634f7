// docs/accuracy.md says what the tests check, of every kernel of the registry, for it is written from their table:
//   ZONAL_WRITE_DOCUMENTS=1 build/release/tests/test_documents
#include <zonal/kernels/kernel_list.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../accuracy_document.hpp"
#include "../catch.hpp"
#include "public_functions.hpp"

namespace {

using namespace zonal::kernels;
using zonal::accuracy::kAnyScalar;
using zonal::accuracy::kFunctions;
using zonal::accuracy::kKernels;
using zonal::accuracy::kOfManyBands;
using zonal::accuracy::kOverData;

std::vector<std::string> split(std::string_view list, char at) {
  std::vector<std::string> parts;
  std::istringstream text{std::string(list)};
  for (std::string part; std::getline(text, part, at);) parts.push_back(part);
  return parts;
}

// Those for colours run the others three times.
template <class Visit>
void for_each_promised(const Visit& visit) {
  for_each_kernel(BasisKernels{}, visit);
  for_each_kernel(SceneKernels{}, visit);
  for_each_kernel(UnwrittenKernels{}, visit);
}

std::string accuracy_document() {
  std::ostringstream text;
  text << "# Accuracy\n\n"
          "The greatest errors that the library promises, how they are known, and the worst inputs found. They are "
          "constants of\n"
          "`zonal/accuracy.hpp`: `zonal::accuracy_bound(\"evaluate\", \"float\", 5)`. The tests check these very "
          "numbers, and write\n"
          "this page. An input counts as exact: what its own rounding does to the result is not the function's error; "
          "and of a\n"
          "choice the exact result takes the side that the function took. An ulp is the scalar's epsilon times what is "
          "named; of\n"
          "a shadow pair the wide number may err by a sixteenth of the narrow one's.\n\n"
          "- **proof**: by intervals over the whole range, which `zonal-prove` prints; of roundings, of constants too, "
          "and whether\n"
          "  or not a compiler fuses products and sums. What a formula leaves out, as the end of a series, is not "
          "among them: the\n"
          "  tests set it against definitions. The tests prove all bounds of up to 10 bands again; those of\n"
          "  `evaluate`, `evaluate_even` and `evaluate_zonal` at 5 bands have a second proof, by Gappa.\n"
          "- **every input**: every number of the scalar in the range was tried.\n"
          "- **search**: no proof; random inputs and hill climbing have found nothing worse, which leaves a margin.\n\n"
          "The worst inputs stand in hexadecimal, or, where they have more than four numbers, in "
          "`tests/data/worst_inputs.csv`.\n"
          "The kernels by their names in the registry, which are those of the shader functions. Where the scalar is "
          "\"any\", what\n"
          "random inputs of every scalar stay below stands in brackets.\n\n";
  text << accuracy_columns;
  for_each_promised([&](auto entry) { text << accuracy_rows<decltype(entry)>(kKernels); });
  text << "\nWith the number of bands known at run time ([many_bands](rooms/many_bands.md)), against "
          "Boost.Multiprecision;\n"
          "half of the directions at a sine of 1 down to the least normal number:\n\n"
       << accuracy_columns;
  for (const Accuracy& row : kOfManyBands) text << accuracy_row(row, "");
  text << "\nOther functions:\n\n" << accuracy_columns;
  for (const Accuracy& row : kFunctions) text << accuracy_row(row, "");
  text << "\nFunctions over data: sums over lights and texels, lookups, fits. Their errors come of the rows above and "
          "of "
          "sums, and\n"
          "hang on the data: none is proved; the tests of their rooms measure them on what the range names.\n\n"
       << accuracy_columns;
  for (const Accuracy& row : kOverData) text << accuracy_row(row, "");
  text << "\nEvery public function, and where it stands above, or why it does not. Classes are not among them, but for "
          "those with\n"
          "rows of their own.\n\n| room | functions | rows, or why there is none |\n| --- | --- | --- |\n";
  for (const Covered& covered : kCovered) {
    text << "| " << covered.room << " | `";
    for (const std::string& name : split(covered.functions, ' ')) {
      if (name != split(covered.functions, ' ').front()) text << "`, `";
      text << name;
    }
    text << "` | ";
    for (const std::string& row : split(covered.rows, ';')) {
      if (row != split(covered.rows, ';').front()) text << "; ";
      text << row;
    }
    text << covered.why << " |\n";
  }
  return text.str();
}

using Name = std::pair<std::string, std::string>;  // room, function

bool starts_with(const std::string& text, std::string_view start) { return text.rfind(start, 0) == 0; }

/// The name that a declaration declares at the beginning of a line, as clang-format leaves it; empty where it is none
/// of a function.
std::string declared_function(const std::string& line) {
  if (line.empty() || std::isspace(static_cast<unsigned char>(line[0])) != 0) return "";
  for (const std::string_view other :
       {"#", "}", "/", "template", "namespace", "inline namespace", "struct", "class", "using", "enum", "static_assert",
        "extern", "friend", "public", "private", "decltype"}) {
    if (starts_with(line, other)) return "";
  }
  const std::size_t end = line.find('(');
  if (end == std::string::npos || line.find_first_of("={") < end || line.find("//") < end) return "";
  std::size_t begin = end;
  const auto is_of_name = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  while (begin > 0 && is_of_name(line[begin - 1])) --begin;
  const bool is_name = begin < end && (std::islower(static_cast<unsigned char>(line[begin])) != 0);
  return is_name ? line.substr(begin, end - begin) : "";
}

/// Those that the headers declare outside of the namespace detail.
std::set<Name> public_functions() {
  namespace fs = std::filesystem;
  std::set<Name> names;
  for (const auto& entry : fs::recursive_directory_iterator(ZONAL_SOURCE "/include/zonal")) {
    const std::string room = entry.path().parent_path().filename().string();
    if (entry.path().extension() != ".hpp" || room == "zonal") continue;
    std::ifstream file(entry.path());
    std::vector<std::string> within;
    for (std::string line; std::getline(file, line);) {
      const std::size_t at = line.find("namespace ");
      if (starts_with(line, "}  // namespace")) {
        within.pop_back();
      } else if (at == 0 || starts_with(line, "inline namespace ")) {
        const std::size_t first = at + std::string_view("namespace ").size();
        within.push_back(line.substr(first, line.find(' ', first) - first));
      } else if (std::none_of(within.begin(), within.end(),
                              [](const std::string& name) { return starts_with(name, "detail"); })) {
        const std::string function = declared_function(line);
        const bool is_reference = std::find(within.begin(), within.end(), "reference") != within.end();
        if (!function.empty()) names.emplace(room, (is_reference ? "reference::" : "") + function);
      }
    }
  }
  return names;
}

template <class Rows>
void append_names(const Rows& rows, std::set<Name>& names) {
  for (const Accuracy& row : rows) names.emplace(row.room, row.function);
}

}  // namespace

TEST_CASE("Every public function has a row in the table of accuracy, or a reason to have none") {
  std::set<Name> rows;
  append_names(kKernels, rows);
  append_names(kFunctions, rows);
  append_names(kOfManyBands, rows);
  append_names(kOverData, rows);
  const auto has_row = [&](const std::string& name) {
    return std::any_of(rows.begin(), rows.end(), [&](const Name& row) { return row.second == name; });
  };
  std::set<Name> covered;
  for (const Covered& entry : kCovered) {
    CAPTURE(entry.room, entry.functions);
    CHECK(entry.rows.empty() != entry.why.empty());
    for (const std::string& row : split(entry.rows, ';')) {
      CAPTURE(row);
      CHECK(has_row(row));
    }
    for (const std::string& function : split(entry.functions, ' ')) {
      CAPTURE(function);
      CHECK(covered.emplace(entry.room, function).second);  // once
    }
  }
  const std::set<Name> declared = public_functions();
  CHECK(declared.size() > 200);
  for (const Name& name : declared) {
    CAPTURE(name.first, name.second);
    CHECK(covered.count(name) == 1);
  }
  for (const Name& name : covered) {
    CAPTURE(name.first, name.second);
    CHECK(declared.count(name) == 1);
  }
}

TEST_CASE("docs/accuracy.md is the table that the tests check") {
  const std::string path = ZONAL_DOCUMENTS "/accuracy.md";
  if (std::getenv("ZONAL_WRITE_DOCUMENTS") != nullptr) std::ofstream(path) << accuracy_document();
  std::ostringstream found;
  found << std::ifstream(path).rdbuf();
  CHECK(found.str() == accuracy_document());
}

TEST_CASE("docs/accuracy.md has every kernel of the registry, and no other") {
  std::set<std::string> names;
  for_each_promised([&](auto entry) {
    names.insert(entry.name);
    INFO(entry.name);
    CHECK_NOTHROW(accuracy_of(entry.name, kAnyScalar, run_bands));
  });
  for (const Accuracy& row : kKernels) {
    INFO(row.function);
    CHECK(names.count(std::string(row.function)) == 1);
  }
}
