#include "built_bands.hpp"
#include "tables.hpp"

namespace zonal_bench {

void print_batches(std::ostream& out, const Results& results) {
  out << "Many directions at once: ns per direction, one thread, beside memset of as many bytes\n\n"
      << "          512 kB, in cache             128 MB, past the caches\n"
      << "bands    fill    rows  planes            fill    rows  planes\n";
  for (const int bands : {5, 10, 20}) {
    out << format("%5d", bands);
    for (const char* where : {"cache", "memory"}) {
      for (const char* name : {"batch-fill", "batch-rows", "batch-planes"}) {
        const Result* result = find(results, kernel_name(name, bands) + "/" + where);
        out << (result ? format("%8.2f", result->median_ns()) : format("%8s", "-"));
      }
      out << (where[0] == 'c' ? "        " : "\n");
    }
  }
  if (const Result* sum = find(results, kernel_name("sum-of-samples", 5) + "/float")) {
    out << format("\nsum += evaluate<5>(direction) * colour: %.2f ns per sample\n", sum->median_ns());
  }
  for (const int bands : {3, 4}) {
    const Result* copy = find(results, kernel_name("splats-copy", bands) + "/halves");
    const Result* adjoint = find(results, kernel_name("splats-adjoint", bands) + "/halves");
    if (copy == nullptr || adjoint == nullptr) continue;
    out << format(
        "splats of %d bands in 16 bits, colours and derivatives: %.2f ns each; a copy of the bytes %.2f: %.0f %%\n",
        bands, adjoint->median_ns(), copy->median_ns(), 100 * copy->median_ns() / adjoint->median_ns());
  }
}

}  // namespace zonal_bench
