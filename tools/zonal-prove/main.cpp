// zonal-prove: how far rounding can carry the kernels of the basis and the lobes.
//
//   zonal-prove                                     proves every bound of zonal/accuracy.hpp that is said to be proved
//   zonal-prove --function evaluate --bands 5       as low a bound as so many parts of the range give
//   zonal-prove --function evaluate --search 1000   and the worst input that so many climbs find
//   zonal-prove --function evaluate_zonal --bands 5 --gappa 0      its bound over part 0 of the range, for gappa
#include <zonal/accuracy.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include "gappa.hpp"
#include "prove.hpp"
#include "search.hpp"

namespace {

using namespace zonal_prove;

/// Whether the bound that the table has is proved.
bool check_kept(const Provable& provable, const zonal::Accuracy& row) {
  const Check check = check_bound(provable.subject(), provable.greatest, row.bound, 40);
  std::printf("%s, %s, %d bands: %g of %s %s, in %ld parts\n", std::string(row.function).c_str(),
              std::string(row.scalar).c_str(), row.bands, row.bound, std::string(row.unit).c_str(),
              check.holds ? "is proved" : "is NOT proved", check.parts);
  std::fflush(stdout);
  return check.holds;
}

bool check_all_kept() {
  bool all_hold = true;
  for (const zonal::Accuracy& row : zonal::accuracy::kKernels) {
    if (row.ground != zonal::Ground::proved) continue;
    for (const Provable& provable : find_provables(row.function, row.scalar, row.bands)) {
      all_hold = check_kept(provable, row) && all_hold;
    }
  }
  return all_hold;
}

void print_lowest(const Provable& provable, long parts) {
  const Proof proof = lowest_bound(provable.subject(), provable.greatest, parts);
  std::printf("%s, %s, %d bands: no error above %.4g, proved in %ld parts\n", std::string(provable.function).c_str(),
              std::string(provable.scalar).c_str(), provable.bands, proof.bound, proof.parts);
}

void print_worst(const Provable& provable, unsigned seed, int climbs) {
  const WorstInput worst = search(provable.subject(), provable.greatest, seed, climbs, 300);
  std::printf("  worst of %ld inputs: %.6g at", worst.tried, worst.error);
  for (const double input : worst.inputs) std::printf(" %a", input);
  std::printf("; %ld results were infinite or no numbers\n", worst.not_numbers);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Bounds of the rounding errors of zonal's kernels, proved; of all in zonal/accuracy.hpp where none is named");
  std::string function, scalar = "float";
  int bands = 5, climbs = 0, part = -1;
  unsigned seed = 1;
  long parts = 2000;
  app.add_option("--function", function, "a kernel of the basis or the lobes");
  app.add_option("--scalar", scalar, "float or double")->capture_default_str();
  app.add_option("--bands", bands, "5, 10 or 21")->capture_default_str();
  app.add_option("--parts", parts, "into how many parts the range is cut")->capture_default_str();
  app.add_option("--search", climbs, "also seek the worst input, by so many climbs");
  app.add_option("--seed", seed, "of the search")->capture_default_str();
  app.add_option("--gappa", part, "print a script that proves the kept bound over this part of the range instead");
  CLI11_PARSE(app, argc, argv);

  if (function.empty()) return check_all_kept() ? 0 : 1;
  const std::vector<Provable> found = find_provables(function, scalar, bands);
  if (found.empty()) {
    std::fprintf(stderr, "zonal-prove: no such kernel, scalar and number of bands\n");
    return 1;
  }
  if (part >= 0) {
    const Subject subject = found.front().subject();
    const std::vector<Part> all = whole_domain(subject, found.front().greatest);
    if (!can_write_gappa(subject) || static_cast<std::size_t>(part) >= all.size()) {
      std::fprintf(stderr, "zonal-prove: a kernel with choices, or fewer parts: %zu\n", all.size());
      return 1;
    }
    const double bound = zonal::accuracy_bound(function, scalar, bands);
    std::fputs(gappa_script(subject, all[static_cast<std::size_t>(part)], bound).c_str(), stdout);
    return 0;
  }
  for (const Provable& provable : found) {
    print_lowest(provable, parts);
    if (climbs > 0) print_worst(provable, seed, climbs);
  }
  return 0;
}
