#include "prove.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace zonal_prove {

namespace {

using zonal::kernels::Domain;

// ---- Where inputs lie -----------------------------------------------------------------------------------------------

/// Cosine and sine of an angle, from the tangent of its half.
struct CosineSine {
  Centred cosine, sine;
};
CosineSine of_half_tangent(const Centred& w, const CellOffsets& offsets) {
  const Centred one{Interval(1)};
  Centred w2 = square(w);
  w2.narrow(offsets);
  const Centred sum = one + w2;
  CosineSine result{(one - w2) / sum, (w + w) / sum};
  result.cosine.narrow(offsets);
  result.sine.narrow(offsets);
  // Both are monotonous up to a right angle: their ranges are those of the ends.
  const auto at = [](double t) { return Interval(t) * Interval(t); };
  const auto cosine_at = [&](double t) { return (Interval(1) - at(t)) / (Interval(1) + at(t)); };
  const auto sine_at = [&](double t) { return (Interval(t) + Interval(t)) / (Interval(1) + at(t)); };
  const double low = w.range.lower(), high = w.range.upper();
  result.cosine.range = hull(cosine_at(low), cosine_at(high));
  result.sine.range = hull(sine_at(low), sine_at(high));
  return result;
}

Centred with_sign(const Centred& a, int sign) { return sign < 0 ? -a : a; }

bool is_power_of_two(const Interval& a) {
  int exponent;
  return a.lower() == a.upper() && a.lower() != 0 && std::abs(std::frexp(a.lower(), &exponent)) == 0.5;
}
bool is_zero(const Interval& a) { return a.lower() == 0 && a.upper() == 0; }

}  // namespace

// ---- The whole domain -----------------------------------------------------------------------------------------------

namespace {

enum class Parity : char { even, odd, mixed };

/// Whether a change of sign of these inputs changes nothing but signs of nodes: then errors are the same to the bit.
bool is_symmetric(const Trace& trace, const std::vector<int>& flipped) {
  std::vector<Parity> parity(trace.nodes.size(), Parity::even);
  for (const int node : flipped) parity[static_cast<std::size_t>(node)] = Parity::odd;
  for (std::size_t i = 0; i < trace.nodes.size(); ++i) {
    const Node& node = trace.nodes[i];
    const auto of = [&](int k) { return parity[static_cast<std::size_t>(node.operands[k])]; };
    switch (node.operation) {
      case Operation::input:
      case Operation::constant: break;
      case Operation::negate: parity[i] = of(0); break;
      case Operation::absolute: parity[i] = of(0) == Parity::mixed ? Parity::mixed : Parity::even; break;
      case Operation::multiply:
      case Operation::divide:
        parity[i] = of(0) == Parity::mixed || of(1) == Parity::mixed ? Parity::mixed
                    : of(0) == of(1)                                 ? Parity::even
                                                                     : Parity::odd;
        break;
      case Operation::add:
      case Operation::subtract: {
        const auto is_zero_constant = [&](int k) {
          const Node& operand = trace.nodes[static_cast<std::size_t>(node.operands[k])];
          return operand.operation == Operation::constant && operand.constant == 0;
        };
        parity[i] = is_zero_constant(0) ? of(1) : is_zero_constant(1) ? of(0) : of(0) == of(1) ? of(0) : Parity::mixed;
        break;
      }
      default:  // a choice: the same only where nothing changes
        for (int k = 0; k < 3; ++k) {
          if (node.operands[k] >= 0 && of(k) != Parity::even) parity[i] = Parity::mixed;
        }
    }
    if (parity[i] == Parity::mixed) return false;
  }
  return true;
}

}  // namespace

std::vector<Part> whole_domain(const Subject& subject, double greatest) {
  std::vector<Part> parts{{{{0, 0}, {0, 0}}}};
  const auto split = [&](int k, const std::vector<double>& ends) {
    std::vector<Part> result;
    for (const Part& part : parts) {
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        result.push_back(part);
        result.back().cell.low[k] = ends[i];
        result.back().cell.high[k] = ends[i + 1];
      }
    }
    parts = std::move(result);
  };
  const auto both_signs = [&](std::size_t axis) {
    const std::size_t count = parts.size();
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(parts[i]);
      parts.back().signs[axis] = -1;
    }
  };
  const auto octaves = [](double low, double high) {
    std::vector<double> ends{high};
    while (ends.back() > low) ends.push_back(ends.back() / 2);
    std::reverse(ends.begin(), ends.end());
    return ends;
  };
  const auto eighths = [] {
    std::vector<double> ends;
    for (int i = 0; i <= 8; ++i) ends.push_back(i / 8.0);
    return ends;
  }();
  int k = 0;
  std::size_t next = 0;
  for (const auto& parameter : subject.parameters) {
    if (parameter.direction == zonal::kernels::Direction::out) continue;
    const std::size_t first = next;
    next += static_cast<std::size_t>(parameter.size());
    const auto flip = [&](std::size_t input) { return std::vector<int>{subject.trace.inputs[first + input]}; };
    if (parameter.domain == Domain::unit_vector || parameter.domain == Domain::cosine) {
      const bool is_vector = parameter.domain == Domain::unit_vector;
      for (std::size_t axis = is_vector ? 0 : 2; axis < 3; ++axis) {
        if (!is_symmetric(subject.trace, flip(is_vector ? axis : 0))) both_signs(axis);
      }
      for (int i = 0; i < (is_vector ? 2 : 1); ++i) split(k++, eighths);
    } else if (parameter.domain == Domain::angle || parameter.domain == Domain::half_angle) {
      if (parameter.domain == Domain::angle) both_signs(0);
      split(k++, octaves(0x1p-41, 1));
    } else if (parameter.domain == Domain::exponent) {
      std::vector<double> ends = octaves(0x1p-10, greatest);
      ends.insert(ends.begin(), 0);
      split(k++, ends);
    } else if (parameter.domain != Domain::coefficient) {
      throw std::invalid_argument("no cells of such a domain");
    }
    if (k > parameter_count) throw std::invalid_argument("too many parameters");
  }
  return parts;
}

// ---- A part ---------------------------------------------------------------------------------------------------------

Prover::Prover(const Subject& subject)
    : subject_(subject),
      values_(subject.trace.nodes.size()),
      worth_(values_.size()),
      errors_(values_.size()),
      handed_(values_.size()),
      is_shared_(values_.size(), 0),
      is_reached_(values_.size()),
      answers_(values_.size(), unknown) {
  std::vector<int> uses(values_.size(), 0);
  std::vector<char> is_in_sum(values_.size(), 0);
  for (const Node& node : subject.trace.nodes) {
    const bool is_sum = node.operation == Operation::add || node.operation == Operation::subtract;
    for (const int operand : node.operands) {
      if (operand < 0) continue;
      ++uses[static_cast<std::size_t>(operand)];
      if (is_sum) is_in_sum[static_cast<std::size_t>(operand)] = 1;
    }
  }
  for (const int output : subject.trace.outputs) ++uses[static_cast<std::size_t>(output)];
  for (std::size_t i = 0; i < uses.size(); ++i) {
    is_shared_[i] = subject.trace.nodes[i].operation == Operation::multiply && is_in_sum[i] && uses[i] > 1;
  }
}

void Prover::set_inputs(const Part& part) {
  Centred parameters[parameter_count];
  for (int k = 0; k < parameter_count; ++k) {
    offsets_.of[k] = part.cell.offset(k);
    parameters[k] = Centred(Interval(part.cell.middle(k)));
    parameters[k].range = part.cell.range(k);
    parameters[k].slope[k] = Interval(1);
  }
  // Inputs need not be unit vectors, or cosines and sines, but up to 4 ulp.
  const double slack = std::ldexp(1.0, 2 - subject_.trace.digits);
  const Centred factor{Interval(1 - slack, 1 + slack)};
  std::size_t next = 0;
  int k = 0;
  const auto set = [&](const Centred& value) {
    values_[static_cast<std::size_t>(subject_.trace.inputs[next++])] = value;
  };
  for (const auto& parameter : subject_.parameters) {
    if (parameter.direction == zonal::kernels::Direction::out) continue;
    switch (parameter.domain) {
      case Domain::unit_vector: {
        const CosineSine polar = of_half_tangent(parameters[0], offsets_);
        const CosineSine around = of_half_tangent(parameters[1], offsets_);
        Centred x = polar.sine * around.cosine, y = polar.sine * around.sine;
        x.narrow(offsets_);
        y.narrow(offsets_);
        set(factor * with_sign(x, part.signs[0]));
        set(factor * with_sign(y, part.signs[1]));
        set(factor * with_sign(polar.cosine, part.signs[2]));
        k = 2;
        break;
      }
      case Domain::cosine: set(with_sign(parameters[k++], part.signs[2])); break;
      case Domain::angle:
      case Domain::half_angle: {
        const CosineSine angle = of_half_tangent(parameters[k++], offsets_);
        set(factor * with_sign(angle.cosine, part.signs[0]));
        set(factor * angle.sine);
        break;
      }
      case Domain::exponent: set(parameters[k++]); break;
      default:
        for (int i = 0; i < parameter.size(); ++i) set(Centred(Interval(-1, 1)));
    }
  }
}

void Prover::run_forwards() {
  const Trace& trace = subject_.trace;
  open_ = -1;
  for (std::size_t i = 0; i < trace.nodes.size(); ++i) {
    const Node& node = trace.nodes[i];
    const auto of = [&](int k) -> const Centred& { return values_[static_cast<std::size_t>(node.operands[k])]; };
    const auto is_product = [&](int k) {
      return trace.nodes[static_cast<std::size_t>(node.operands[k])].operation == Operation::multiply;
    };
    const auto compare = [&](bool is_surely, bool is_surely_not) {
      if (is_surely || is_surely_not) return Centred(Interval(is_surely ? 1 : 0));
      if (answers_[i] != unknown) return Centred(Interval(answers_[i]));
      if (open_ < 0) open_ = static_cast<int>(i);
      return Centred(Interval(0, 1));
    };
    Centred& value = values_[i];
    bool is_exact = false;
    errors_[i] = 0;
    switch (node.operation) {
      case Operation::input: continue;
      case Operation::constant: {
        const double exact = static_cast<double>(node.constant);
        const long double rounded = trace.digits <= 24 ? static_cast<long double>(static_cast<float>(node.constant))
                                                       : static_cast<long double>(static_cast<double>(node.constant));
        value = Centred(Interval(exact));
        if (rounded == node.constant) continue;
        // The constant itself is known to 64 binary digits, and kept here to 53.
        const double rest = std::abs(exact) * 0x1p-52;
        errors_[i] = static_cast<double>(std::abs(rounded - node.constant)) + std::abs(exact) * 0x1p-61;
        value.widen(errors_[i] + rest);
        continue;
      }
      case Operation::negate: value = -of(0), is_exact = true; break;
      case Operation::absolute:
        value = of(0).range.lower() >= 0 ? of(0) : of(0).range.upper() <= 0 ? -of(0) : hull(of(0), -of(0));
        value.range = boost::numeric::abs(of(0).range);
        value.centre = boost::numeric::abs(of(0).centre);
        is_exact = true;
        break;
      case Operation::add:
      case Operation::subtract: {
        const bool is_add = node.operation == Operation::add;
        value = is_add ? of(0) + of(1) : of(0) - of(1);
        const Interval a = of(0).range, b = is_add ? -of(1).range : of(1).range;
        const auto is_within_two = [](const Interval& low, const Interval& high) {
          return low.lower() > 0 && high.lower() * 2 >= low.upper() && low.lower() * 2 >= high.upper();
        };
        is_exact = is_zero(a) || is_zero(b) || (is_add && node.operands[0] == node.operands[1]) ||
                   (!is_product(0) && !is_product(1) && (is_within_two(a, b) || is_within_two(-a, -b)));
        break;
      }
      case Operation::multiply:
        value = node.operands[0] == node.operands[1] ? square(of(0)) : of(0) * of(1);
        is_exact = is_zero(of(0).range) || is_zero(of(1).range);
        if (is_power_of_two(of(0).range) || is_power_of_two(of(1).range)) {
          errors_[i] = std::ldexp(1.0, trace.least_exponent - 1);  // of a number that becomes subnormal
          is_exact = true;
        }
        break;
      case Operation::divide: value = of(0) / of(1); break;
      case Operation::square_root: value = sqrt(of(0)); break;
      case Operation::minimum:
      case Operation::maximum: {
        const bool is_max = node.operation == Operation::maximum;
        const Centred &a = of(0), &b = of(1);
        if (a.range.upper() <= b.range.lower()) {
          value = is_max ? b : a;
        } else if (b.range.upper() <= a.range.lower()) {
          value = is_max ? a : b;
        } else {
          value = hull(a, b);
          value.range = is_max ? boost::numeric::max(a.range, b.range) : boost::numeric::min(a.range, b.range);
          value.centre = is_max ? boost::numeric::max(a.centre, b.centre) : boost::numeric::min(a.centre, b.centre);
        }
        is_exact = true;
        break;
      }
      case Operation::less:
        value = compare(of(0).range.upper() < of(1).range.lower(), of(0).range.lower() >= of(1).range.upper());
        continue;
      case Operation::less_equal:
        value = compare(of(0).range.upper() <= of(1).range.lower(), of(0).range.lower() > of(1).range.upper());
        continue;
      case Operation::select:
        value = of(0).range.lower() > 0 ? of(1) : of(0).range.upper() <= 0 ? of(2) : hull(of(1), of(2));
        is_exact = true;
        break;
    }
    value.narrow(offsets_);
    if (!is_exact) {
      const double size = magnitude(value.range);
      errors_[i] = size == 0 ? 0
                   : std::isfinite(size)
                       ? std::ldexp(1.0, (std::max)(std::ilogb(size) - trace.digits, trace.least_exponent - 1))
                       : size;
    }
    if (errors_[i] > 0) value.widen(errors_[i]);
  }
}

void Prover::give(int node, const Centred& share) {
  const auto i = static_cast<std::size_t>(node);
  if (subject_.trace.nodes[i].operation == Operation::input) return;
  worth_[i] = is_reached_[i] ? worth_[i] + share : share;
  worth_[i].narrow(offsets_);
  if (is_shared_[i]) handed_[i] = (is_reached_[i] ? handed_[i] : 0) + magnitude(share.range);
  is_reached_[i] = 1;
}

void Prover::hand_on(std::size_t i) {
  const Node& node = subject_.trace.nodes[i];
  const int* to = node.operands;
  const auto of = [&](int k) -> const Centred& { return values_[static_cast<std::size_t>(to[k])]; };
  const Centred w = worth_[i];
  const auto narrowed = [&](Centred share) {
    share.narrow(offsets_);
    return share;
  };
  const auto perhaps = [&] { return hull(w, Centred()); };
  switch (node.operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::less:
    case Operation::less_equal: break;
    case Operation::negate: give(to[0], -w); break;
    case Operation::add:
      give(to[0], w);
      give(to[1], w);
      break;
    case Operation::subtract:
      give(to[0], w);
      give(to[1], -w);
      break;
    case Operation::multiply:
      if (to[0] == to[1]) {
        give(to[0], narrowed(Centred(Interval(2)) * w * of(0)));
        break;
      }
      give(to[0], narrowed(w * of(1)));
      give(to[1], narrowed(w * of(0)));
      break;
    case Operation::divide: {
      const Centred quotient = narrowed(w / of(1));
      give(to[0], quotient);
      give(to[1], -narrowed(quotient * values_[i]));
      break;
    }
    case Operation::square_root: give(to[0], narrowed(w / (values_[i] + values_[i]))); break;
    case Operation::absolute:
      give(to[0], of(0).range.lower() >= 0 ? w : of(0).range.upper() <= 0 ? -w : hull(w, -w));
      break;
    case Operation::minimum:
    case Operation::maximum: {
      const int first = node.operation == Operation::minimum ? 0 : 1, second = 1 - first;
      if (of(first).range.upper() <= of(second).range.lower()) {
        give(to[first], w);
      } else if (of(second).range.upper() <= of(first).range.lower()) {
        give(to[second], w);
      } else {
        give(to[0], perhaps());
        give(to[1], perhaps());
      }
      break;
    }
    case Operation::select:
      if (of(0).range.lower() > 0) {
        give(to[1], w);
      } else if (of(0).range.upper() <= 0) {
        give(to[2], w);
      } else {
        give(to[1], perhaps());
        give(to[2], perhaps());
      }
      break;
  }
}

double Prover::error_of(int output) {
  const auto last = static_cast<std::size_t>(output);
  std::fill(is_reached_.begin(), is_reached_.begin() + static_cast<std::ptrdiff_t>(last) + 1, char(0));
  give(output, Centred(Interval(1)));
  double error = 0;
  for (std::size_t i = last + 1; i-- > 0;) {
    if (!is_reached_[i]) continue;
    if (errors_[i] > 0) error += errors_[i] * (is_shared_[i] ? handed_[i] : magnitude(worth_[i].range));
    hand_on(i);
  }
  return error;
}

double Prover::unit_of(std::size_t output) const {
  // Of the exact result, and below it by more than this computation errs.
  if (subject_.unit != Unit::largest) return unit_of_degree(subject_.unit, subject_.degrees[output]) * (1 - 1e-14);
  double largest = 0;
  for (const int node : subject_.trace.outputs) {
    const Interval& range = values_[static_cast<std::size_t>(node)].range;
    largest = std::fmax(largest, std::fmax(range.lower(), -range.upper()));
  }
  return largest * (1 - std::ldexp(8.0, -subject_.trace.digits));
}

double Prover::bound(const Part& part) {
  const Rounding rounding;
  set_inputs(part);
  return bound_choices(8);
}

std::vector<Interval> Prover::ranges(const Part& part) {
  const Rounding rounding;
  set_inputs(part);
  std::vector<Interval> result;
  for (const int input : subject_.trace.inputs) result.push_back(values_[static_cast<std::size_t>(input)].range);
  return result;
}

double Prover::bound_choices(int depth) {
  run_forwards();
  double result = 0;
  if (open_ >= 0 && depth > 0) {
    const auto comparison = static_cast<std::size_t>(open_);
    for (const char answer : {char(0), char(1)}) {
      answers_[comparison] = answer;
      result = std::fmax(result, bound_choices(depth - 1));
    }
    answers_[comparison] = unknown;
    return result;
  }
  for (std::size_t k = 0; k < subject_.trace.outputs.size(); ++k) {
    if (subject_.degrees[k] < 0) continue;
    const double error = error_of(subject_.trace.outputs[k]) / unit_of(k);
    result = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::fmax(result, error);
  }
  return result;
}

// ---- All parts ------------------------------------------------------------------------------------------------------

std::array<Part, 2> halves(const Part& part) {
  const auto length = [&](int k) { return part.cell.high[k] - part.cell.low[k]; };
  const int k = length(1) > length(0) ? 1 : 0;
  std::array<Part, 2> result{part, part};
  result[0].cell.high[k] = result[1].cell.low[k] = part.cell.middle(k);
  return result;
}

Proof lowest_bound(const Subject& subject, double greatest, long parts) {
  Prover prover(subject);
  const auto is_better = [](const Proof& a, const Proof& b) { return a.bound < b.bound; };
  std::priority_queue<Proof, std::vector<Proof>, decltype(is_better)> open(is_better);
  const auto add = [&](const Part& part) { open.push({prover.bound(part), part, 0}); };
  long count = 0;
  for (const Part& part : whole_domain(subject, greatest)) add(part), ++count;
  for (; count < parts; count += 2) {
    const Part worst = open.top().worst;
    open.pop();
    for (const Part& half : halves(worst)) add(half);
  }
  Proof result = open.top();
  result.parts = count;
  return result;
}

namespace {
void check_part(Prover& prover, const Part& part, double bound, int depth, Check& check) {
  if (!check.holds) return;
  ++check.parts;
  if (prover.bound(part) <= bound) return;
  if (depth == 0) {
    check.holds = false;
    check.failed = part;
    return;
  }
  for (const Part& half : halves(part)) check_part(prover, half, bound, depth - 1, check);
}
}  // namespace

Check check_bound(const Subject& subject, double greatest, double bound, int depth, long stride, long first) {
  Prover prover(subject);
  Check check;
  long i = 0;
  // A share is taken of parts that are small from the start: each of the domain's, halved eight times.
  const auto visit = [&](auto&& self, const Part& part, int level) -> void {
    if (level == 0) {
      if (i++ % stride == first) check_part(prover, part, bound, depth, check);
      return;
    }
    for (const Part& half : halves(part)) self(self, half, level - 1);
  };
  for (const Part& part : whole_domain(subject, greatest)) visit(visit, part, stride > 1 ? 8 : 0);
  return check;
}

}  // namespace zonal_prove
