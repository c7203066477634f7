#include "many_lights_scene.hpp"
#include "tables.hpp"

namespace zonal_bench {

void print_many_lights(std::ostream& out, const Results& results) {
  out << "A tree of lights that send one band, a wall and the floor before it, cut for 1 % of 5 bands, one thread: "
         "ns\n\n"
      << format("%-40s", "");
  for (const int count : tree_lights) out << format("%8d lights", count);
  out << "\n";
  for (const TreeStep& step : tree_steps) {
    out << format("%-40s", step.title);
    for (const int count : tree_lights) {
      const Result* result = find(results, kernel_name(step.name, cut_bands) + "/" + std::to_string(count));
      out << (result ? format("%15.0f", result->median_ns()) : format("%15s", "-"));
    }
    out << "\n";
  }
}

}  // namespace zonal_bench
