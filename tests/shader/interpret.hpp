// A record run an operation at a time, in float: what a compiler of its text must come to.
#pragma once

#include <zonal/scalar/scalar.hpp>
#include <zonal/shader/recorded_function.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

/// The outputs that the function writes, for these inputs.
inline std::vector<float> interpret(const zonal::shader::RecordedFunction& function, const std::vector<float>& inputs) {
  using zonal::Operation;
  const auto& lines = function.recording->lines();
  std::vector<float> values(lines.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto operand = [&](int k) { return values[static_cast<std::size_t>(lines[i].operands[k])]; };
    float& value = values[i];
    switch (lines[i].operation) {
      case Operation::input: value = inputs.at(next++); break;
      case Operation::constant: value = lines[i].constant; break;
      case Operation::negate: value = -operand(0); break;
      case Operation::add: value = operand(0) + operand(1); break;
      case Operation::subtract: value = operand(0) - operand(1); break;
      case Operation::multiply: value = operand(0) * operand(1); break;
      case Operation::divide: value = operand(0) / operand(1); break;
      case Operation::minimum: value = operand(1) < operand(0) ? operand(1) : operand(0); break;
      case Operation::maximum: value = operand(0) < operand(1) ? operand(1) : operand(0); break;
      case Operation::absolute: value = std::abs(operand(0)); break;
      case Operation::square_root: value = std::sqrt(operand(0)); break;
      case Operation::less: value = operand(0) < operand(1) ? 1.0F : 0.0F; break;
      case Operation::less_equal: value = operand(0) <= operand(1) ? 1.0F : 0.0F; break;
      case Operation::select: value = operand(0) > 0 ? operand(1) : operand(2); break;
    }
  }
  std::vector<float> outputs;
  for (const zonal::Recorder& output : function.kept_outputs()) {
    outputs.push_back(output.is_constant() ? output.constant() : values[static_cast<std::size_t>(output.line())]);
  }
  return outputs;
}

/// Of all outputs those that the function writes.
inline std::vector<float> kept_of(const zonal::shader::RecordedFunction& function, const std::vector<float>& all) {
  std::vector<float> kept;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (function.kept[k]) kept.push_back(all[k]);
  }
  return kept;
}
