// What is proved: a kernel's trace, where its inputs lie, and what its errors are measured in.
#pragma once

#include <zonal/kernels/kernel_io.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "trace.hpp"

namespace zonal_prove {

/// What an error is measured in.
enum class Unit {
  of_the_degree,  // sqrt((2l+1)/4pi), the largest value that Y_l^0 has
  steepest,       // the degree's steepest slope
  largest,        // the largest output
  one,            //
};

/// One that hangs on the degree alone.
inline double unit_of_degree(Unit unit, int degree) {
  const double l = degree, largest = std::sqrt((2 * l + 1) / 12.566370614359172954);
  return unit == Unit::of_the_degree ? largest
         : unit == Unit::steepest    ? largest * std::fmax(1, std::sqrt(l * (l + 1) / 2))
                                     : 1;
}

struct Subject {
  Trace trace;
  std::vector<zonal::kernels::Parameter> parameters;
  Unit unit = Unit::one;
  std::vector<int> degrees;  // of each output that counts; the others have -1
};

using TracedRun = void (*)(Trace& trace, std::vector<zonal::kernels::Parameter>& parameters);

// Runs an entry of the registry, of as many bands, on a trace.
template <class Entry, int N, class Lane>
void trace_entry(Trace& trace, std::vector<zonal::kernels::Parameter>& parameters) {
  using T = Traced<Lane>;
  T::trace = &trace;
  zonal::kernels::DescribingIo<T> io([](const zonal::kernels::Parameter&) { return T::input(); });
  Entry::template run<N>(io);
  parameters = io.parameters();
  for (const T& output : io.outputs()) trace.outputs.push_back(output.node());
}

/// A kernel of which bounds can be proved: the directions, angles or numbers that it takes are cells' parameters.
struct Provable {
  std::string_view function, scalar;  // "float" or "double"
  int bands;
  Unit unit;
  double greatest;  // of a parameter that has no end by itself
  TracedRun run;

  Subject subject() const;
};

/// Some functions are there twice: of built-in numbers C++ may take the steps in another order (gradient_rows.hpp).
const std::vector<Provable>& provables();
/// All there are, or none.
std::vector<Provable> find_provables(std::string_view function, std::string_view scalar, int bands);

}  // namespace zonal_prove
