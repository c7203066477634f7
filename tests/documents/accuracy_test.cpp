// docs/accuracy.md says what the tests check, for it is written from their table:
//   ZONAL_WRITE_DOCUMENTS=1 build/release/tests/test_documents
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "../accuracy_table.hpp"
#include "../catch.hpp"

namespace {

std::string accuracy_document() {
  std::ostringstream text;
  text << "# Accuracy\n\n"
          "The greatest errors that the library promises. The tests check these very numbers, and write this page.\n"
          "Random directions and angles have fixed seeds; half of the directions lie near a pole. An input counts as\n"
          "exact: what its own rounding does to the result is not the function's error.\n\n"
          "| function | scalar | bands | range | greatest error | in units of |\n"
          "| --- | --- | --- | --- | --- | --- |\n";
  for (const Accuracy& row : kAccuracyTable) {
    text << "| `" << row.function << "` | " << row.scalar << " | " << (row.bands > 0 ? std::to_string(row.bands) : "")
         << " | " << row.range << " | " << row.bound << " | " << row.unit << " |\n";
  }
  return text.str();
}

}  // namespace

TEST_CASE("docs/accuracy.md is the table that the tests check") {
  const std::string path = ZONAL_DOCUMENTS "/accuracy.md";
  if (std::getenv("ZONAL_WRITE_DOCUMENTS") != nullptr) std::ofstream(path) << accuracy_document();
  std::ostringstream found;
  found << std::ifstream(path).rdbuf();
  CHECK(found.str() == accuracy_document());
}
