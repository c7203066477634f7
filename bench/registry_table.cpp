// Every kernel of the registry: operations and times.
#include <ostream>
#include <string>

#include "tables.hpp"

namespace zonal_bench {

void print_registry(std::ostream& out, const Results& results) {
  out << "Every kernel of the registry, those with bands at 5: operations, counted by the recorder, and ns, one thread\n\n"
      << format("%-42s%8s%10s%10s\n", "kernel/bands", "ops", "float", "packet");
  for (const std::string& name : registry_names()) {
    const Result* one = find(results, name + "/float");
    const Result* packet = find(results, name + "/packet");
    const auto ns = [](const Result* r) { return r ? format("%10.2f", r->median_ns()) : format("%10s", "-"); };
    out << format("%-42s", name.c_str()) << (one ? format("%8d", one->operations()) : format("%8s", "-")) << ns(one)
        << ns(packet) << "\n";
  }
}

}  // namespace zonal_bench
