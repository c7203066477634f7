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
}

}  // namespace zonal_bench
