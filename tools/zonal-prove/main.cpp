// zonal-prove: how far rounding can carry the kernels of the basis and the lobes.
//
//   zonal-prove                                     proves every bound of zonal/accuracy.hpp that is said to be proved
//   zonal-prove --function evaluate --bands 5       as low a bound as so many parts of the range give
//   zonal-prove --function evaluate --search 1000   and the worst input that so many climbs find
//   zonal-prove --function evaluate_zonal --bands 5 --gappa 0      its bound over part 0 of the range, for gappa
#include <zonal/accuracy.hpp>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <stdexcept>
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

struct Options {
  std::string function, scalar = "float";
  int bands = 5, climbs = 0;
  unsigned seed = 1;
  long parts = 2000;
  std::optional<std::size_t> gappa_part;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--function", options.function, "a kernel of the basis or the lobes");
  app.add_option("--scalar", options.scalar, "float or double")
      ->capture_default_str()
      ->check(CLI::IsMember({"float", "double"}));
  app.add_option("--bands", options.bands, "5, 10 or 21")->capture_default_str()->check(CLI::IsMember({5, 10, 21}));
  app.add_option("--parts", options.parts, "into how many parts the range is cut")
      ->capture_default_str()
      ->check(CLI::Range(1L, 1000000000L));
  app.add_option("--search", options.climbs, "also seek the worst input, by so many climbs")
      ->check(CLI::Range(1, 1000000000));
  app.add_option("--seed", options.seed, "of the search")->capture_default_str();
  app.add_option("--gappa", options.gappa_part,
                 "print a script that proves the kept bound over this part of the range instead");
}

std::string script_of(const Provable& provable, std::size_t part, double bound) {
  const Subject subject = provable.subject();
  if (!can_write_gappa(subject))
    throw std::runtime_error("--gappa: " + std::string(provable.function) + " has choices");
  const std::vector<Part> all = whole_domain(subject, provable.greatest);
  if (part >= all.size()) {
    throw std::runtime_error("--gappa: the range has the parts 0 to " + std::to_string(all.size() - 1));
  }
  return gappa_script(subject, all[part], bound);
}

/// The exit status.
int run(const Options& options) {
  if (options.function.empty()) return check_all_kept() ? 0 : 1;
  const std::vector<Provable> found = find_provables(options.function, options.scalar, options.bands);
  if (found.empty()) {
    throw std::runtime_error("--function: there is no '" + options.function + "' of " + options.scalar + " with " +
                             std::to_string(options.bands) + " bands");
  }
  if (options.gappa_part) {
    const double bound = zonal::accuracy_bound(options.function, options.scalar, options.bands);
    std::fputs(script_of(found.front(), *options.gappa_part, bound).c_str(), stdout);
    return 0;
  }
  for (const Provable& provable : found) {
    print_lowest(provable, options.parts);
    if (options.climbs > 0) print_worst(provable, options.seed, options.climbs);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Bounds of the rounding errors of zonal's kernels, proved; of all in zonal/accuracy.hpp where none is named");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
    return run(options);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-prove: %s\n", error.what());
    return 2;
  }
}
