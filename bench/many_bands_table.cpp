#include <string>

#include "many_bands_rows.hpp"
#include "tables.hpp"

namespace zonal_bench {

void print_many_bands(std::ostream& out, const Results& results) {
  out << "Bands known at run time, in loops, beside kernels unrolled for as many: ns per direction, cap or function, "
         "one "
         "thread\n\n"
      << format("%-28s", "bands");
  for (const int n : looped_bands) out << format("%12d", n);
  out << "\n";
  for (const char* kernel : many_bands_kernels) {
    for (const char* scalar : {"float", "double"}) {
      for (const char* way : {"-unrolled", "-looped"}) {
        out << format("%-28s", (std::string(kernel) + way + ", " + scalar).c_str());
        for (const int n : looped_bands) {
          const Result* result = find(results, kernel_name(std::string(kernel) + way, n) + "/" + scalar);
          out << (result ? format("%12.0f", result->median_ns()) : format("%12s", "-"));
        }
        out << "\n";
      }
    }
  }
}

}  // namespace zonal_bench
