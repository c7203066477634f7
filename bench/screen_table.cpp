#include "screen_pictures.hpp"
#include "tables.hpp"

namespace zonal_bench {

void print_screen(std::ostream& out, const Results& results) {
  const Result* copies = find(results, kernel_name("screen-two-copies", screen_bands) + "/float");
  out << "Discontinuity filter of 27 floats a pixel, 1280x720, in place, one thread: ns per pixel\n\n"
      << format("%-22s%10s\n", "copying them twice", copies ? format("%.1f", copies->median_ns()).c_str() : "-");
  for (const ScreenCase& screen : screen_cases) {
    const Result* filter = find(results, kernel_name("screen-filter", screen_bands) + "/" + screen.name);
    out << format("%-22s", screen.name)
        << (filter && copies ? format("%10.1f%10.2f", filter->median_ns(), filter->median_ns() / copies->median_ns())
                             : format("%10s%10s", "-", "-"))
        << "\n";
  }
}

}  // namespace zonal_bench
