// The papers' tables, with what was measured here in place of, or beside, what they print.
#pragma once

#include <ostream>

#include "results.hpp"

namespace zonal_bench {

/// Harmonics Virtual Lights, CGF 41(6), 2022.
void print_hvl_figure_6(std::ostream& out, const Results& results);

/// Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
void print_gradient_table_1(std::ostream& out, const Results& results);
void print_gradient_table_2(std::ostream& out, const Results& results);
void print_gradient_figure_15(std::ostream& out);

/// Batches of directions beside a plain fill, and sums of samples: no paper's.
void print_batches(std::ostream& out, const Results& results);

/// Pictures of all directions beside the sum of their texels: no paper's.
void print_environments(std::ostream& out, const Results& results);

/// The screen's filter beside copies of what it filters: no paper's.
void print_screen(std::ostream& out, const Results& results);

/// The tree of many lights, step by step: no paper's.
void print_many_lights(std::ostream& out, const Results& results);

/// Bands known at run time beside unrolled kernels: no paper's.
void print_many_bands(std::ostream& out, const Results& results);

/// All kernels of the registry, those of the papers' tables among them.
void print_registry(std::ostream& out, const Results& results);

}  // namespace zonal_bench
