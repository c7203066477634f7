// A scalar that does nothing but write down what is done to it: operation counts, and shader text from the record.
//
//   Recording recording;
//   auto y = evaluate<5>(std::array{recording.input("x"), recording.input("y"), recording.input("z")});
//   OperationCount count = recording.count(y.begin(), y.end());
//
// Two constants combine to a constant in float, as the C++ kernel does; x+0, x-0, x*1 and x/1 are x, and x*0 is 0: for
// finite numbers, and up to the sign of a zero. An operation that was written before on the same operands is not
// written again. What the asked-for outputs do not need does not count.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class Operation : std::uint8_t {
  input,
  constant,
  negate,
  add,
  subtract,
  multiply,
  divide,
  minimum,
  maximum,
  absolute,
  square_root,
  less,
  less_equal,
  select,
};

class Recording;

/// A float constant, or the result of a line of a Recording.
class Recorder {
 public:
  Recorder() = default;  // indeterminate, as a float
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  explicit Recorder(C constant) : recording_(nullptr), line_(-1), constant_(static_cast<float>(constant)) {}

  bool is_constant() const { return recording_ == nullptr; }
  float constant() const { return constant_; }
  int line() const { return line_; }

 private:
  friend class Recording;
  Recorder(Recording* recording, int line) : recording_(recording), line_(line), constant_(0) {}

  Recording* recording_;
  int line_;
  float constant_;
};

/// What comparing two Recorders gives.
struct RecorderMask {
  Recorder flag;  // a line, or the constant 0 or 1
};

/// How often each kind of arithmetic occurs.
struct OperationCount {
  int additions = 0;        // + - and unary -
  int multiplications = 0;  // *
  int divisions = 0;        // /
  int functions = 0;        // sqrt
  int comparisons = 0;      // < <= min max abs select
  int fused = 0;            // of the additions and of the multiplications: pairs that can be done as one multiply-add
  int total() const { return additions + multiplications + divisions + functions + comparisons; }
};

/// The record: a list of lines, each an operation on earlier lines.
class Recording {
 public:
  struct Line {
    Operation operation;
    int operands[3];   // line numbers; -1 where unused
    float constant;    // for Operation::constant
    std::string name;  // for Operation::input
  };

  Recording() = default;
  Recording(const Recording&) = delete;  // recorders point at their recording
  Recording& operator=(const Recording&) = delete;

  Recorder input(std::string name) {
    lines_.push_back({Operation::input, {-1, -1, -1}, 0, std::move(name)});
    return {this, static_cast<int>(lines_.size()) - 1};
  }

  const std::vector<Line>& lines() const { return lines_; }

  /// What a line gives; of a constant, the constant.
  Recorder result_of(int line) {
    const Line& of_line = lines_[static_cast<std::size_t>(line)];
    return of_line.operation == Operation::constant ? Recorder(of_line.constant) : Recorder(this, line);
  }

  /// Whether each line is needed by the outputs [first, last).
  template <class Iterator>
  std::vector<bool> needed(Iterator first, Iterator last) const {
    std::vector<bool> live(lines_.size(), false);
    for (; first != last; ++first) {
      if (!first->is_constant()) live[static_cast<std::size_t>(first->line())] = true;
    }
    for (std::size_t i = lines_.size(); i-- > 0;) {
      if (!live[i]) continue;
      for (int operand : lines_[i].operands) {
        if (operand >= 0) live[static_cast<std::size_t>(operand)] = true;
      }
    }
    return live;
  }

  /// The operations that the outputs [first, last) need.
  template <class Iterator>
  OperationCount count(Iterator first, Iterator last) const {
    const std::vector<bool> live = needed(first, last);
    OperationCount count;
    count.fused = fused(live, first, last);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!live[i]) continue;
      switch (lines_[i].operation) {
        case Operation::input:
        case Operation::constant: break;
        case Operation::negate:
        case Operation::add:
        case Operation::subtract: ++count.additions; break;
        case Operation::multiply: ++count.multiplications; break;
        case Operation::divide: ++count.divisions; break;
        case Operation::square_root: ++count.functions; break;
        case Operation::minimum:
        case Operation::maximum:
        case Operation::absolute:
        case Operation::less:
        case Operation::less_equal:
        case Operation::select: ++count.comparisons; break;
      }
    }
    return count;
  }

  /// Writes an operation down, unless it stands already. At least one operand is not a constant.
  static Recorder write(Operation operation, const Recorder& a, const Recorder& b = Recorder(0),
                        const Recorder& c = Recorder(0), int operand_count = 1) {
    Recording& recording = *(a.recording_ ? a : b.recording_ ? b : c).recording_;
    int operands[3] = {-1, -1, -1};
    const Recorder* given[3] = {&a, &b, &c};
    for (int i = 0; i < operand_count; ++i) operands[i] = recording.line_of(*given[i]);
    return {&recording, recording.find_or_append(operation, operands, 0)};
  }

 private:
  // The additions of a product that nothing else needs.
  template <class Iterator>
  int fused(const std::vector<bool>& live, Iterator first, Iterator last) const {
    std::vector<int> uses(lines_.size(), 0);
    const auto use = [&](int line) {
      if (line >= 0) ++uses[static_cast<std::size_t>(line)];
    };
    for (; first != last; ++first) use(first->line());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (live[i]) std::for_each(std::begin(lines_[i].operands), std::end(lines_[i].operands), use);
    }
    const auto is_product = [&](int line) {
      const auto i = static_cast<std::size_t>(line);
      return lines_[i].operation == Operation::multiply && uses[i] == 1;
    };
    int count = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto& [operation, operands, constant, name] = lines_[i];
      const bool is_sum = operation == Operation::add || operation == Operation::subtract;
      if (live[i] && is_sum && (is_product(operands[0]) || is_product(operands[1]))) ++count;
    }
    return count;
  }

  int line_of(const Recorder& r) {
    if (!r.is_constant()) return r.line();
    const int none[3] = {-1, -1, -1};
    return find_or_append(Operation::constant, none, r.constant());
  }

  int find_or_append(Operation operation, const int (&operands)[3], float constant) {
    // a + b is b + a, but stays written as it was first.
    const bool commutes = operation == Operation::add || operation == Operation::multiply;
    const bool swaps = commutes && operands[1] < operands[0];
    const auto key = std::make_tuple(operation, operands[swaps], operands[!swaps], operands[2], constant);
    const auto [entry, is_new] = index_.try_emplace(key, static_cast<int>(lines_.size()));
    if (is_new) lines_.push_back({operation, {operands[0], operands[1], operands[2]}, constant, {}});
    return entry->second;
  }

  std::vector<Line> lines_;
  std::map<std::tuple<Operation, int, int, int, float>, int> index_;
};

namespace detail {
inline bool is(const Recorder& a, float constant) { return a.is_constant() && is_equal(a.constant(), constant); }
// The one line of every unary and of every binary operation: fold constants with `fold`, or write it down.
template <class Fold>
Recorder record(Operation operation, const Recorder& a, Fold fold) {
  return a.is_constant() ? Recorder(fold(a.constant())) : Recording::write(operation, a);
}
template <class Fold>
Recorder record(Operation operation, const Recorder& a, const Recorder& b, Fold fold) {
  if (a.is_constant() && b.is_constant()) return Recorder(fold(a.constant(), b.constant()));
  return Recording::write(operation, a, b, Recorder(0), 2);
}
}  // namespace detail

inline Recorder operator-(const Recorder& a) {
  return detail::record(Operation::negate, a, [](float x) { return -x; });
}
inline Recorder operator+(const Recorder& a, const Recorder& b) {
  if (detail::is(a, 0)) return b;
  if (detail::is(b, 0)) return a;
  return detail::record(Operation::add, a, b, [](float x, float y) { return x + y; });
}
inline Recorder operator-(const Recorder& a, const Recorder& b) {
  if (detail::is(b, 0)) return a;
  return detail::record(Operation::subtract, a, b, [](float x, float y) { return x - y; });
}
inline Recorder operator*(const Recorder& a, const Recorder& b) {
  if (detail::is(a, 1)) return b;
  if (detail::is(b, 1)) return a;
  if (detail::is(a, 0) || detail::is(b, 0)) return Recorder(0);
  return detail::record(Operation::multiply, a, b, [](float x, float y) { return x * y; });
}
inline Recorder operator/(const Recorder& a, const Recorder& b) {
  if (detail::is(b, 1)) return a;
  return detail::record(Operation::divide, a, b, [](float x, float y) { return x / y; });
}
inline Recorder minimum(const Recorder& a, const Recorder& b) {
  return detail::record(Operation::minimum, a, b, [](float x, float y) { return minimum(x, y); });
}
inline Recorder maximum(const Recorder& a, const Recorder& b) {
  return detail::record(Operation::maximum, a, b, [](float x, float y) { return maximum(x, y); });
}
inline Recorder abs(const Recorder& a) {
  return detail::record(Operation::absolute, a, [](float x) { return abs(x); });
}
inline Recorder sqrt(const Recorder& a) {
  return detail::record(Operation::square_root, a, [](float x) { return sqrt(x); });
}
inline RecorderMask operator<(const Recorder& a, const Recorder& b) {
  return {detail::record(Operation::less, a, b, [](float x, float y) { return x < y ? 1.0F : 0.0F; })};
}
inline RecorderMask operator<=(const Recorder& a, const Recorder& b) {
  return {detail::record(Operation::less_equal, a, b, [](float x, float y) { return x <= y ? 1.0F : 0.0F; })};
}
inline RecorderMask operator>(const Recorder& a, const Recorder& b) { return b < a; }
inline RecorderMask operator>=(const Recorder& a, const Recorder& b) { return b <= a; }
inline Recorder select(const RecorderMask& mask, const Recorder& a, const Recorder& b) {
  if (mask.flag.is_constant()) return mask.flag.constant() > 0 ? a : b;
  return Recording::write(Operation::select, mask.flag, a, b, 3);
}

template <>
struct ScalarTraits<Recorder> {
  using Lane = float;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
