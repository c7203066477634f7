// A function on a driver, of OpenGL or Vulkan, against its record.
#pragma once

#include <zonal/shader/file_text.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include "caller.hpp"
#include "compare.hpp"
#include "inputs.hpp"
#include "interpret.hpp"

inline constexpr unsigned sample_group_size = 64, sample_groups = 8;
inline constexpr std::size_t sample_count = sample_group_size * sample_groups;

/// A compute shader that calls one of the functions once per invocation: the one that `which` says, an expression.
template <class Functions>
std::string function_shader(const Functions& functions, const std::string& which,
                            const zonal::shader::TextOptions& options) {
  const zonal::shader::Dialect& glsl = *zonal::shader::find_dialect("glsl450");
  std::string texts, calls;
  int number = 0;
  for (const zonal::shader::RecordedFunction& function : functions) {
    texts += function_text(function, glsl, options) + caller_text(function, "uint", options);
    calls += "  if (" + which + " == " + std::to_string(number++) + ") call_" + function.name + "(i * " +
             std::to_string(input_count(function)) + "u, i * " + std::to_string(output_count(function)) + "u);\n";
  }
  return "layout(local_size_x = " + std::to_string(sample_group_size) +
         ") in;\n"
         "layout(std430, binding = 0) readonly buffer Numbers { float numbers[]; };\n"
         "layout(std430, binding = 1) writeonly buffer Results { float results[]; };\n" +
         texts + "void main() {\n  uint i = gl_GlobalInvocationID.x;\n" + calls + "}\n";
}

/// run(numbers) gives what the function gives of samples, one after the other, against its record, an operation at a
/// time.
template <class Run>
void check_as_recorded(const zonal::shader::RecordedFunction& function, int bands, bool to_the_bit, const Run& run) {
  InputSampler sampler(7, bands);
  std::vector<std::vector<float>> inputs;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < sample_count; ++i) {
    inputs.push_back(sampler.draw(function.parameters));
    numbers.insert(numbers.end(), inputs.back().begin(), inputs.back().end());
  }
  INFO(function.name);
  const std::vector<float> results = run(numbers);
  const auto count = static_cast<std::size_t>(output_count(function));
  REQUIRE(results.size() == sample_count * count);
  for (std::size_t i = 0; i < sample_count; ++i) {
    const std::vector<float> given(results.begin() + static_cast<std::ptrdiff_t>(i * count),
                                   results.begin() + static_cast<std::ptrdiff_t>((i + 1) * count));
    require_equal(given, interpret(function, inputs[i]), to_the_bit, [&] { return inputs[i]; });
  }
}
