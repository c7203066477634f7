// The basis, by the recurrences and by explicit polynomials.
#include "evaluation.hpp"

namespace zonal_report {

void print_basis(Effort effort) {
  KernelTable table("evaluation", effort);
  zonal_bench::for_evaluate_kernels([&](auto kernel) { table.add<decltype(kernel)>(); });
  table.print();
}

void print_evaluation(Effort effort) {
  print_row("quantity", "form", "scalar", "lanes", "bands", "ns", "error");
  print_basis(effort);
  print_gradient(effort);
  print_lobes(effort);
}

}  // namespace zonal_report
