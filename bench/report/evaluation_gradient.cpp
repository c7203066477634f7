// The basis with its gradient: by the ladder, by differentiated polynomials, by Sloan's like recurrences and angles.
#include "evaluation.hpp"

void zonal_report::print_gradient(Effort effort) {
  KernelTable table("gradient", effort);
  const auto add = [&](auto kernel) { table.add<decltype(kernel)>(); };
  zonal_bench::at<zonal_bench::kernels::EvaluateWithGradient>(zonal_bench::GradientBands{}, add);
  zonal_bench::at<zonal_bench::PolynomialGradient>(zonal_bench::GradientBands{}, add);
  zonal_bench::at<zonal_bench::SloanLike>(zonal_bench::GradientBands{}, add);
  table.print();
}
