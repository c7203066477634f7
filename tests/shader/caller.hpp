// Functions between flat arrays of floats, in the language of the function they call: for GLSL, and for the same text
// as C++.
#pragma once

#include <zonal/shader/function_text.hpp>

#include <string>

/// `void call_<name>(<index> from, <index> to)`: the inputs are numbers[from], numbers[from + 1], ..., and the outputs
/// that it writes go to results[to], results[to + 1], ....
inline std::string caller_text(const zonal::shader::RecordedFunction& function, const std::string& index_type,
                               const zonal::shader::TextOptions& options = {}) {
  using zonal::shader::Direction;
  using zonal::shader::Parameter;
  std::string declarations, reads, arguments, writes, result;
  int from = 0, to = 0;
  std::size_t output = 0, outputs = 0;
  for (const Parameter& p : function.parameters) outputs += p.direction != Direction::in;
  const auto element = [](const Parameter& p, int i) {
    std::string text = p.name;
    if (p.is_array()) text += "[" + std::to_string(i / p.components) + "]";
    if (p.components > 1) text += "." + std::string(1, "xyz"[i % p.components]);
    return text;
  };
  for (const Parameter& p : function.parameters) {
    const std::string type = p.components == 1 ? "float" : p.components == 2 ? "vec2" : "vec3", name = p.name;
    declarations += "  " + type + " " + name + (p.is_array() ? "[" + std::to_string(p.count) + "]" : "") + ";\n";
    if (p.direction != Direction::out) {
      for (int i = 0; i < p.size(); ++i) {
        reads += "  " + element(p, i) + " = numbers[from + " + std::to_string(from++) + "];\n";
      }
    }
    const bool is_result = outputs == 1 && p.direction == Direction::out && !p.is_array();
    if (is_result) {
      result = name + " = ";
    } else if (options.flat && p.is_array()) {
      for (int i = 0; i < p.count; ++i) {
        arguments += (arguments.empty() ? "" : ", ") + name + "[" + std::to_string(i) + "]";
      }
    } else {
      arguments += (arguments.empty() ? "" : ", ") + name;
    }
    if (p.direction != Direction::in) {
      for (int i = 0; i < p.size(); ++i) {
        if (function.kept[output++]) {
          writes += "  results[to + " + std::to_string(to++) + "] = " + element(p, i) + ";\n";
        }
      }
    }
  }
  return "void call_" + function.name + "(" + index_type + " from, " + index_type + " to) {\n" + declarations + reads +
         "  " + result + text_name(function, options) + "(" + arguments + ");\n" + writes + "}\n";
}

/// The numbers that a function takes, and those that it gives.
inline int input_count(const zonal::shader::RecordedFunction& function) {
  int count = 0;
  for (const auto& p : function.parameters) count += p.direction != zonal::shader::Direction::out ? p.size() : 0;
  return count;
}
inline int output_count(const zonal::shader::RecordedFunction& function) {
  return static_cast<int>(function.kept_outputs().size());
}
