// The basis with its gradient: by the ladder, by differentiated polynomials, by Sloan's like recurrences and angles.
#include "evaluation.hpp"

void zonal_report::print_gradient(Effort effort) {
  KernelTable table("gradient", effort);
  zonal_bench::for_bands(zonal_bench::GradientBands{}, [&](auto n) {
    table.add<zonal_bench::Gradient<n>>();
    table.add<zonal_bench::PolynomialGradient<n>>();
    table.add<zonal_bench::SloanLike<n>>();
  });
  table.print();
}
