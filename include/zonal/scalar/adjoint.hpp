// Derivatives of what has been recorded: the reverse sweep, written into the same recording.
//
//   Recording recording;
//   const Recorder x = recording.input("x"), y = recording.input("y"), by_f = recording.input("by_f");
//   const Recorder f = sqrt(x * y);
//   const std::vector<Recorder> by = adjoints(recording, {f}, {by_f}, {x, y});  // by_f df/dx, by_f df/dy
//
// From the last line to the first, each hands what it is worth on to its operands [1], whatever the number of inputs.
// The record holds no operation twice: value and derivatives together take fewer operations than each for itself, and
// those that nothing asked for needs do not count.
//
// Of two branches the one taken counts, as in a Dual (dual.hpp): minimum, maximum, abs and select are derived as they
// have chosen. A comparison has no derivative, and hands nothing on. That of a square root is infinite at 0; but where
// a choice follows, which may have been against it, it is taken to be 0 there, or infinity times 0 would come of it.
//
// [1] Griewank and Walther, Evaluating Derivatives, 2nd edition, SIAM, 2008, chapter 3.
#pragma once

#include <cstddef>
#include <vector>

#include "recorder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// What a line is worth: the sum of what its users hand it. What is to be subtracted is kept apart, or many lines would
// be negations.
struct Worth {
  Recorder plus = Recorder(0), minus = Recorder(0);

  void add(const Recorder& share, bool is_minus) {
    Recorder& sum = is_minus ? minus : plus;
    sum = sum + share;
  }
  bool is_nothing() const { return is(plus, 0) && is(minus, 0); }
  /// Whether the sign of `magnitude` has to be changed.
  bool is_minus() const { return is(plus, 0); }
  Recorder magnitude() const { return is_minus() ? minus : plus - minus; }
};

class ReverseSweep {
 public:
  ReverseSweep(Recording& recording, const std::vector<Recorder>& inputs)
      : recording_(recording),
        worth_(recording.lines().size()),
        depends_(worth_.size(), false),
        is_choice_(worth_.size(), false) {
    for (const Recorder& input : inputs) depends_[index(input)] = true;
    for (std::size_t i = 0; i < depends_.size(); ++i) {
      for (const int operand : recording.lines()[i].operands) {
        if (operand >= 0 && depends_[static_cast<std::size_t>(operand)]) depends_[i] = true;
      }
    }
  }

  /// Lines that depend on no input asked for are worth nothing.
  bool depends(const Recorder& line) const { return !line.is_constant() && depends_[index(line)]; }
  void add(const Recorder& line, const Recorder& share, bool is_minus) {
    if (depends(line)) worth_[index(line)].add(share, is_minus);
  }
  void run() {
    for (std::size_t i = worth_.size(); i-- > 0;) {
      if (!worth_[i].is_nothing()) hand_on(i, worth_[i].magnitude(), worth_[i].is_minus());
    }
  }
  Recorder result(const Recorder& input) const {
    const Worth& worth = worth_[index(input)];
    return worth.is_minus() ? -worth.magnitude() : worth.magnitude();
  }

 private:
  static std::size_t index(const Recorder& line) { return static_cast<std::size_t>(line.line()); }

  Recorder operand(std::size_t line, int k) const {
    const int operand = recording_.lines()[line].operands[k];
    return operand < 0 ? Recorder(0) : recording_.result_of(operand);
  }

  // `w`, or -w, is what the line is worth. Shares are written down only where they count.
  void hand_on(std::size_t line, const Recorder& w, bool is_minus) {
    const Recorder result = recording_.result_of(static_cast<int>(line));
    const Recorder a = operand(line, 0), b = operand(line, 1), c = operand(line, 2);
    const Operation operation = recording_.lines()[line].operation;
    const bool is_choice = is_choice_[line] || operation == Operation::minimum || operation == Operation::maximum ||
                           operation == Operation::select;
    const auto give = [&](const Recorder& to, const auto& share, bool changes_sign = false) {
      if (!depends(to)) return;
      add(to, share(), is_minus != changes_sign);
      if (is_choice) is_choice_[index(to)] = true;
    };
    const auto whole = [&] { return w; };
    const auto where = [&](const RecorderMask& mask) { return [=] { return select(mask, w, Recorder(0)); }; };
    const auto elsewhere = [&](const RecorderMask& mask) { return [=] { return select(mask, Recorder(0), w); }; };
    switch (operation) {
      case Operation::input:
      case Operation::constant:
      case Operation::less:
      case Operation::less_equal: break;
      case Operation::negate: give(a, whole, true); break;
      case Operation::add:
        give(a, whole);
        give(b, whole);
        break;
      case Operation::subtract:
        give(a, whole);
        give(b, whole, true);
        break;
      case Operation::multiply:
        if (!a.is_constant() && !b.is_constant() && a.line() == b.line()) {  // w + w is often there already
          give(a, [&] { return (w + w) * a; });
          break;
        }
        give(a, [&] { return w * b; });
        give(b, [&] { return w * a; });
        break;
      case Operation::divide: {
        const auto quotient = [&] { return is(a, 1) ? w * result : w / b; };
        give(a, quotient);
        give(
            b, [&] { return quotient() * result; }, true);
        break;
      }
      case Operation::minimum:
        give(a, elsewhere(b < a));
        give(b, where(b < a));
        break;
      case Operation::maximum:
        give(a, elsewhere(a < b));
        give(b, where(a < b));
        break;
      case Operation::absolute: give(a, [&] { return select(a < Recorder(0), -w, w); }); break;
      case Operation::square_root:
        give(a, [&] {
          const Recorder share = w / (result + result);
          return is_choice ? select(Recorder(0) < result, share, Recorder(0)) : share;
        });
        break;
      case Operation::select:
        give(b, where({a}));
        give(c, elsewhere({a}));
        break;
    }
  }

  Recording& recording_;
  std::vector<Worth> worth_;     // by line, of those that were there before
  std::vector<bool> depends_;    // on an input asked for
  std::vector<bool> is_choice_;  // whether it is worth something only where it was chosen
};

}  // namespace detail

/// The derivatives by each of `inputs`, in their order, of the sum of by_outputs[k] times outputs[k]: where by_outputs
/// are a loss's derivatives by the outputs, the loss's by the inputs. Constant 0 where no output changes with the
/// input.
inline std::vector<Recorder> adjoints(Recording& recording, const std::vector<Recorder>& outputs,
                                      const std::vector<Recorder>& by_outputs, const std::vector<Recorder>& inputs) {
  detail::ReverseSweep sweep(recording, inputs);
  for (std::size_t k = 0; k < outputs.size(); ++k) sweep.add(outputs[k], by_outputs[k], false);
  sweep.run();
  std::vector<Recorder> by_inputs;
  for (const Recorder& input : inputs) by_inputs.push_back(sweep.result(input));
  return by_inputs;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
