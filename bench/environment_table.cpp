#include "environment_pictures.hpp"
#include "tables.hpp"

namespace zonal_bench {

void print_environments(std::ostream& out, const Results& results) {
  out << "Pictures to coefficients: ns per texel, float RGB, one thread, beside adding up the texels\n\n"
      << "                                            sum   5 bands  / sum  20 bands  / sum\n";
  for (const EnvironmentPicture& picture : environment_pictures()) {
    const char* name = zonal::mapping_name(picture.mapping);
    out << format("%-18s %5d x %-5d", name, picture.width, picture.height);
    const Result* sum = find(results, kernel_name("environment-sum", 0) + "/" + name);
    out << (sum ? format("%16.2f", sum->median_ns()) : format("%16s", "-"));
    for (const int bands : {5, 20}) {
      const Result* result = find(results, kernel_name("environment", bands) + "/" + name);
      out << (sum && result ? format("%10.2f%7.2f", result->median_ns(), result->median_ns() / sum->median_ns())
                            : format("%10s%7s", "-", "-"));
    }
    out << "\n";
  }
}

}  // namespace zonal_bench
