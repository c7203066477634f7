#include "gappa.hpp"

#include <cstdio>
#include <stdexcept>

namespace zonal_prove {

namespace {

/// In hexadecimal, in which every binary number is exact.
std::string exact_text(long double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%La", number);
  return text;
}

/// Of rounded numbers, "r", and of exact ones, "e"; an input is both.
std::string expression(const Node& node, const std::string& prefix) {
  const auto of = [&](int k) { return prefix + std::to_string(node.operands[k]); };
  switch (node.operation) {
    case Operation::negate: return "-" + of(0);
    case Operation::add: return of(0) + " + " + of(1);
    case Operation::subtract: return of(0) + " - " + of(1);
    case Operation::multiply: return of(0) + " * " + of(1);
    case Operation::divide: return of(0) + " / " + of(1);
    case Operation::square_root: return "sqrt(" + of(0) + ")";
    default: throw std::invalid_argument("Gappa has no choices");
  }
}

}  // namespace

bool can_write_gappa(const Subject& subject) {
  if (subject.unit == Unit::largest) return false;
  for (const auto& parameter : subject.parameters) {
    using zonal::kernels::Domain;
    const bool is_bounded = parameter.domain == Domain::unit_vector || parameter.domain == Domain::cosine;
    if (parameter.direction != zonal::kernels::Direction::out && !is_bounded) return false;
  }
  for (const Node& node : subject.trace.nodes) {
    switch (node.operation) {
      case Operation::absolute:
      case Operation::minimum:
      case Operation::maximum:
      case Operation::less:
      case Operation::less_equal:
      case Operation::select: return false;
      default: break;
    }
  }
  return true;
}

std::string gappa_script(const Subject& subject, const Part& part, double bound) {
  const Trace& trace = subject.trace;
  const bool is_float = trace.digits == 24;
  std::string text = std::string("@rnd = float<") + (is_float ? "ieee_32" : "ieee_64") + ", ne>;\n";
  for (std::size_t i = 0; i < trace.nodes.size(); ++i) {
    const Node& node = trace.nodes[i];
    const std::string number = std::to_string(i);
    if (node.operation == Operation::input) {
      text += "r" + number + " = rnd(x" + number + ");\ne" + number + " = r" + number + ";\n";
    } else if (node.operation == Operation::constant) {
      const long double rounded = is_float ? static_cast<long double>(static_cast<float>(node.constant))
                                           : static_cast<long double>(static_cast<double>(node.constant));
      text += "r" + number + " = " + exact_text(rounded) + ";\ne" + number + " = " + exact_text(node.constant) + ";\n";
    } else {
      // A change of sign is exact, and a function that only the rounded operations round.
      const bool is_exact = node.operation == Operation::negate;
      text += "r" + number + (is_exact ? " = " : " rnd= ") + expression(node, "r") + ";\n";
      text += "e" + number + " = " + expression(node, "e") + ";\n";
    }
  }
  text += "{";
  const char* before = " ";
  const std::vector<Interval> ranges = Prover(subject).ranges(part);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    text += before + ("r" + std::to_string(trace.inputs[i])) + " in [" + exact_text(ranges[i].lower()) + ", " +
            exact_text(ranges[i].upper()) + "]";
    before = " /\\ ";
  }
  before = " ->\n  ";
  for (std::size_t k = 0; k < trace.outputs.size(); ++k) {
    if (subject.degrees[k] < 0) continue;
    if (trace.nodes[static_cast<std::size_t>(trace.outputs[k])].operation == Operation::constant) continue;
    const std::string number = std::to_string(trace.outputs[k]);
    const double unit = unit_of_degree(subject.unit, subject.degrees[k]) * (1 - 1e-14);
    text += before + ("|r" + number) + " - e" + number + "| <= " + exact_text(static_cast<long double>(bound * unit));
    before = " /\\\n  ";
  }
  return text + " }\n";
}

}  // namespace zonal_prove
