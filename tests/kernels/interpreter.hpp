// Runs a Recording: what the operations that a kernel writes down come to in float.
#pragma once

#include <zonal/scalar/recorder.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

/// The value of every line, with these values of the inputs in their order.
inline std::vector<float> interpret(const zonal::Recording& recording, const std::vector<float>& inputs) {
  using zonal::Operation;
  std::vector<float> values;
  std::size_t next_input = 0;
  for (const zonal::Recording::Line& line : recording.lines()) {
    const auto operand = [&](int i) { return values.at(static_cast<std::size_t>(line.operands[i])); };
    float value = 0;
    switch (line.operation) {
      case Operation::input: value = inputs.at(next_input++); break;
      case Operation::constant: value = line.constant; break;
      case Operation::negate: value = -operand(0); break;
      case Operation::add: value = operand(0) + operand(1); break;
      case Operation::subtract: value = operand(0) - operand(1); break;
      case Operation::multiply: value = operand(0) * operand(1); break;
      case Operation::divide: value = operand(0) / operand(1); break;
      case Operation::minimum: value = zonal::minimum(operand(0), operand(1)); break;
      case Operation::maximum: value = zonal::maximum(operand(0), operand(1)); break;
      case Operation::absolute: value = std::abs(operand(0)); break;
      case Operation::square_root: value = std::sqrt(operand(0)); break;
      case Operation::less: value = operand(0) < operand(1) ? 1.0F : 0.0F; break;
      case Operation::less_equal: value = operand(0) <= operand(1) ? 1.0F : 0.0F; break;
      case Operation::select: value = operand(0) != 0 ? operand(1) : operand(2); break;
    }
    values.push_back(value);
  }
  return values;
}

inline float value_of(const zonal::Recorder& output, const std::vector<float>& values) {
  return output.is_constant() ? output.constant() : values.at(static_cast<std::size_t>(output.line()));
}
