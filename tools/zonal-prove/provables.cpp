#include <zonal/kernels/basis_kernels.hpp>
#include <zonal/kernels/lobe_kernels.hpp>

#include <limits>

#include "subject.hpp"

namespace zonal_prove {

using namespace zonal::kernels;

namespace {

// evaluate_with_gradient of numbers, in C++ (basis/gradient_rows.hpp).
template <int N>
void trace_gradient_rows(Trace& trace, std::vector<Parameter>& parameters) {
  using T = Traced<float>;
  T::trace = &trace;
  const T x = T::input(), y = T::input(), z = T::input();
  zonal::Sh<N, T> value, by_x, by_y, by_z;
  zonal::detail::gradient_in_rows<N, T>(x, y, z, value.values, by_x.values, by_y.values, by_z.values);
  parameters = {{"direction", Direction::in, Domain::unit_vector, 3, 0},
                {"y", Direction::out, Domain::coefficient, 1, N * N, true},
                {"gradient", Direction::out, Domain::coefficient, 3, N * N, true, true}};
  for (const T& output : value.values) trace.outputs.push_back(output.node());
  for (int i = 0; i < N * N; ++i) {
    for (const auto* plane : {&by_x, &by_y, &by_z}) trace.outputs.push_back(plane->values[i].node());
  }
}

// A trace is that of all scalars, but where a kernel has series.
template <class Entry, int N, class Lane = float>
void append(std::vector<Provable>& all, std::string_view scalar, Unit unit, double greatest = 0) {
  all.push_back({Entry::name, scalar, N, unit, greatest, trace_entry<Entry, N, Lane>});
}
template <class Entry>
void append_all(std::vector<Provable>& all, Unit unit, double greatest = 0) {
  append<Entry, 5>(all, "float", unit, greatest);
  append<Entry, 10>(all, "float", unit, greatest);
  append<Entry, 21>(all, "float", unit, greatest);
  append<Entry, 21, std::conditional_t<std::is_same_v<Entry, Gaussian>, double, float>>(all, "double", unit, greatest);
}

}  // namespace

const std::vector<Provable>& provables() {
  static const std::vector<Provable> all = [] {
    std::vector<Provable> list;
    append_all<Evaluate>(list, Unit::of_the_degree);
    append_all<EvaluateEven>(list, Unit::of_the_degree);
    append_all<EvaluateZonal>(list, Unit::of_the_degree);
    append<EvaluateWithGradient, 5>(list, "float", Unit::steepest);
    append<EvaluateWithGradient, 10>(list, "float", Unit::steepest);
    list.push_back({EvaluateWithGradient::name, "float", 5, Unit::steepest, 0, trace_gradient_rows<5>});
    list.push_back({EvaluateWithGradient::name, "float", 10, Unit::steepest, 0, trace_gradient_rows<10>});
    for (const char* scalar : {"float", "double"}) {  // to be searched: intervals become too wide
      append<EvaluateWithGradient, 21>(list, scalar, Unit::steepest);
      append<Cap, 51>(list, scalar, Unit::largest);
      append<CapDerivative, 51>(list, scalar, Unit::largest);
    }
    append_all<Cap>(list, Unit::largest);
    append_all<HemisphereCap>(list, Unit::largest);
    append_all<CapDerivative>(list, Unit::largest);
    append_all<Phong>(list, Unit::largest, 1024);
    append_all<Gaussian>(list, Unit::largest, 0x1p20);
    return list;
  }();
  return all;
}

std::vector<Provable> find_provables(std::string_view function, std::string_view scalar, int bands) {
  std::vector<Provable> found;
  for (const Provable& provable : provables()) {
    if (provable.function == function && provable.scalar == scalar && provable.bands == bands) {
      found.push_back(provable);
    }
  }
  return found;
}

Subject Provable::subject() const {
  Subject subject;
  subject.unit = unit;
  const auto set_scalar = [&](auto limits) {
    subject.trace.digits = limits.digits;
    subject.trace.least_exponent = limits.min_exponent - limits.digits;
  };
  if (scalar == "float") set_scalar(std::numeric_limits<float>());
  if (scalar == "double") set_scalar(std::numeric_limits<double>());
  run(subject.trace, subject.parameters);
  // Outputs are coefficients by degree: of all orders, of m >= 0, or zonal; or triples of them.
  for (const Parameter& parameter : subject.parameters) {
    if (parameter.direction != Direction::out) continue;
    const int count = parameter.elements();
    const bool counts = unit != Unit::steepest || parameter.is_gradient;
    for (int i = 0, l = 0; i < count; ++i) {
      const int first_of_next = count == bands * bands ? (l + 1) * (l + 1)
                                : count == bands       ? l + 1
                                                       : (l + 1) * (l + 2) / 2;
      if (i == first_of_next) ++l;
      for (int c = 0; c < parameter.components; ++c) subject.degrees.push_back(counts ? l : -1);
    }
  }
  return subject;
}

}  // namespace zonal_prove
