// A record run an operation at a time: in float, what a compiler of its text must come to.
#pragma once

#include <zonal/scalar/scalar.hpp>
#include <zonal/shader/recorded_function.hpp>

#include <cstddef>
#include <vector>

/// What every line comes to, in any scalar.
template <class T>
std::vector<T> run_lines(const zonal::Recording& recording, const std::vector<T>& inputs) {
  using zonal::abs, zonal::maximum, zonal::minimum, zonal::Operation, zonal::select, zonal::sqrt;
  const auto& lines = recording.lines();
  std::vector<T> values(lines.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto operand = [&](int k) { return values[static_cast<std::size_t>(lines[i].operands[k])]; };
    const auto flag = [](auto mask) { return select(mask, T(1), T(0)); };
    T& value = values[i];
    switch (lines[i].operation) {
      case Operation::input: value = inputs.at(next++); break;
      case Operation::constant: value = T(lines[i].constant); break;
      case Operation::negate: value = -operand(0); break;
      case Operation::add: value = operand(0) + operand(1); break;
      case Operation::subtract: value = operand(0) - operand(1); break;
      case Operation::multiply: value = operand(0) * operand(1); break;
      case Operation::divide: value = operand(0) / operand(1); break;
      case Operation::minimum: value = minimum(operand(0), operand(1)); break;
      case Operation::maximum: value = maximum(operand(0), operand(1)); break;
      case Operation::absolute: value = abs(operand(0)); break;
      case Operation::square_root: value = sqrt(operand(0)); break;
      case Operation::less: value = flag(operand(0) < operand(1)); break;
      case Operation::less_equal: value = flag(operand(0) <= operand(1)); break;
      case Operation::select: value = select(operand(0) > T(0), operand(1), operand(2)); break;
    }
  }
  return values;
}

/// What these of its recorders come to, given the lines.
template <class T>
std::vector<T> values_of(const std::vector<zonal::Recorder>& recorders, const std::vector<T>& lines) {
  std::vector<T> values;
  for (const zonal::Recorder& recorder : recorders) {
    values.push_back(recorder.is_constant() ? T(recorder.constant())
                                            : lines[static_cast<std::size_t>(recorder.line())]);
  }
  return values;
}

/// The outputs that the function writes, for these inputs.
template <class T>
std::vector<T> interpret(const zonal::shader::RecordedFunction& function, const std::vector<T>& inputs) {
  return values_of(function.kept_outputs(), run_lines(*function.recording, inputs));
}

/// Of all outputs those that the function writes.
inline std::vector<float> kept_of(const zonal::shader::RecordedFunction& function, const std::vector<float>& all) {
  std::vector<float> kept;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (function.kept[k]) kept.push_back(all[k]);
  }
  return kept;
}
