// A trace run again: in a scalar, and beside it in one that is exact for it.
#pragma once

#include <zonal/scalar/scalar.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "subject.hpp"

namespace zonal_prove {

/// One run, narrow and exact, with the choices of the narrow one.
template <class Narrow, class Exact>
class Replay {
 public:
  explicit Replay(const Subject& subject)
      : subject_(subject), narrow_(subject.trace.nodes.size()), exact_(narrow_.size()) {}

  void run(const std::vector<Narrow>& inputs) {
    using std::sqrt, zonal::sqrt;
    const Trace& trace = subject_.trace;
    std::size_t next = 0;
    for (std::size_t i = 0; i < narrow_.size(); ++i) {
      const Node& node = trace.nodes[i];
      const auto place = [&](int k) { return static_cast<std::size_t>(node.operands[k]); };
      const auto n = [&](int k) { return narrow_[place(k)]; };
      const auto e = [&](int k) -> const Exact& { return exact_[place(k)]; };
      const auto set = [&](Narrow narrow, const Exact& exact) { narrow_[i] = narrow, exact_[i] = exact; };
      const auto copy = [&](int k) { set(n(k), e(k)); };
      const auto flag = [&](bool is_set) { set(is_set ? Narrow(1) : Narrow(0), Exact(is_set ? 1 : 0)); };
      switch (node.operation) {
        case Operation::input: set(inputs[next], Exact(inputs[next])), ++next; break;
        case Operation::constant: set(static_cast<Narrow>(node.constant), Exact(node.constant)); break;
        case Operation::negate: set(-n(0), -e(0)); break;
        case Operation::add: set(n(0) + n(1), e(0) + e(1)); break;
        case Operation::subtract: set(n(0) - n(1), e(0) - e(1)); break;
        case Operation::multiply: set(n(0) * n(1), e(0) * e(1)); break;
        case Operation::divide: set(n(0) / n(1), e(0) / e(1)); break;
        case Operation::square_root: set(sqrt(n(0)), sqrt(e(0))); break;
        case Operation::minimum: copy(n(1) < n(0) ? 1 : 0); break;
        case Operation::maximum: copy(n(0) < n(1) ? 1 : 0); break;
        case Operation::absolute: n(0) < Narrow(0) ? set(-n(0), -e(0)) : copy(0); break;
        case Operation::less: flag(n(0) < n(1)); break;
        case Operation::less_equal: flag(n(0) <= n(1)); break;
        case Operation::select: copy(n(0) > Narrow(0) ? 1 : 2); break;
      }
    }
  }

  Narrow output(std::size_t k) const { return narrow_[static_cast<std::size_t>(subject_.trace.outputs[k])]; }
  const Exact& exact(std::size_t k) const { return exact_[static_cast<std::size_t>(subject_.trace.outputs[k])]; }

  /// The greatest error of an output that counts, in the subject's unit; infinite where one is no number.
  double error() const {
    double result = 0, largest = 0;
    if (subject_.unit == Unit::largest) {
      for (std::size_t k = 0; k < subject_.trace.outputs.size(); ++k) {
        largest = (std::max)(largest, std::abs(static_cast<double>(exact(k))));
      }
    }
    for (std::size_t k = 0; k < subject_.trace.outputs.size(); ++k) {
      if (subject_.degrees[k] < 0) continue;
      const double unit = subject_.unit == Unit::largest ? largest : unit_of_degree(subject_.unit, subject_.degrees[k]);
      const double error = std::abs(static_cast<double>(Exact(output(k)) - exact(k))) / unit;
      if (!(error <= result)) result = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    }
    return result;
  }

 private:
  const Subject& subject_;
  std::vector<Narrow> narrow_;
  std::vector<Exact> exact_;
};

}  // namespace zonal_prove
