// docs/accuracy.md says what the tests check, of every kernel of the registry, for it is written from their table:
//   ZONAL_WRITE_DOCUMENTS=1 build/release/tests/test_documents
#include <zonal/kernels/kernel_list.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "../accuracy_document.hpp"
#include "../catch.hpp"

namespace {

using namespace zonal::kernels;

// Those for colours run the others three times.
template <class Visit>
void for_each_promised(const Visit& visit) {
  for_each_kernel(BasisKernels{}, visit);
  for_each_kernel(SceneKernels{}, visit);
  for_each_kernel(UnwrittenKernels{}, visit);
}

std::string accuracy_document() {
  std::ostringstream text;
  text
      << "# Accuracy\n\n"
         "The greatest errors that the library promises. The tests check these very numbers, and write this page.\n"
         "Random directions and angles have fixed seeds; half of the directions lie near a pole. An input counts as\n"
         "exact: what its own rounding does to the result is not the function's error. An ulp is the scalar's epsilon\n"
         "times what is named; of a shadow pair the wide number may err by a sixteenth of the narrow one's.\n\n"
         "The kernels by their names in the registry, which are those of the shader functions.\n\n"
         "| kernel | what it gives | scalar | bands | range | greatest error | in units of |\n"
         "| --- | --- | --- | --- | --- | --- | --- |\n";
  for_each_promised([&](auto entry) { text << accuracy_rows<decltype(entry)>(kKernelAccuracy); });
  text << "\nThe functions that every scalar has:\n\n"
          "| function | scalar | range | greatest error | in units of |\n"
          "| --- | --- | --- | --- | --- |\n";
  for (const Accuracy& row : kFunctionAccuracy) {
    text << "| `" << row.kernel << "` | " << row.scalar << " | " << row.range << " | " << row.bound << " | " << row.unit
         << " |\n";
  }
  text << "\nWith the number of bands known at run time ([many_bands](rooms/many_bands.md)), against "
          "Boost.Multiprecision;\n"
          "half of the directions at a sine of 1 down to the least normal number:\n\n"
          "| function | scalar | bands | range | greatest error | in units of |\n"
          "| --- | --- | --- | --- | --- | --- |\n";
  for (const Accuracy& row : kManyBandsAccuracy) {
    text << "| `" << row.kernel << "` | " << row.scalar << " | " << row.bands << " | " << row.range << " | "
         << row.bound << " | " << row.unit << " |\n";
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

TEST_CASE("docs/accuracy.md has every kernel of the registry, and no other") {
  std::set<std::string> names;
  for_each_promised([&](auto entry) {
    names.insert(entry.name);
    INFO(entry.name);
    CHECK_NOTHROW(accuracy_of(entry.name, kAnyScalar, run_bands));
  });
  for (const Accuracy& row : kKernelAccuracy) {
    INFO(row.kernel);
    CHECK(names.count(std::string(row.kernel)) == 1);
  }
}
