// The basis with its gradient: by the ladder, by differentiated polynomials, by Sloan's like recurrences and angles.
#include "evaluation.hpp"

void zonal_report::print_gradient(Effort effort) {
  KernelTable table("gradient", effort);
  zonal::unroll<0, static_cast<int>(zonal_bench::gradient_bands.size())>([&](auto i) {
    constexpr int n = zonal_bench::gradient_bands[std::size_t{i}];
    table.add<zonal_bench::Gradient<n>>();
    table.add<zonal_bench::PolynomialGradient<n>>();
    table.add<zonal_bench::SloanLike<n>>();
  });
  table.print();
}
