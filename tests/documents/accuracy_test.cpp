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
using zonal::accuracy::kAnyScalar;
using zonal::accuracy::kFunctions;
using zonal::accuracy::kKernels;
using zonal::accuracy::kOfManyBands;

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
  text << "\nOther functions. Not listed are those that run these over data: gathers, sums of grids, pictures, fields "
          "and\n"
          "screens, fits, plans and files. Their results hang on the data; the tests of their rooms set them against\n"
          "definitions and references.\n\n"
       << accuracy_columns;
  for (const Accuracy& row : kFunctions) text << accuracy_row(row, "");
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
  for (const Accuracy& row : kKernels) {
    INFO(row.function);
    CHECK(names.count(std::string(row.function)) == 1);
  }
}
