// What a kernel must do in every scalar, by its runs and its record: inputs as a renderer has them, half of the
// directions and angles hard, seeds fixed.
#pragma once

#include <zonal/kernels/sampler.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "../catch.hpp"
#include "../shader/compare.hpp"
#include "../shader/interpret.hpp"
#include "kernel_runs.hpp"

using zonal::kernels::Draw;
using zonal::kernels::InputSampler;
using zonal::shader::RecordedFunction;

template <class To, class From>
std::vector<To> cast(const std::vector<From>& from) {
  std::vector<To> to;
  for (const From& value : from) to.push_back(static_cast<To>(value));
  return to;
}

inline long double largest(const std::vector<long double>& values) {
  long double result = 0;
  for (const long double value : values) result = std::max(result, std::abs(value));
  return result;
}

template <class T>
inline constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

// Of each kernel in each scalar; no power of 10, for lanes.
inline constexpr int draws = 512;

/// A kernel, what it takes, how much it gives, and what is promised.
struct Subject {
  Subject(const KernelRuns& kernel_, RecordedFunction&& function_, const Accuracy& promise_)
      : kernel(kernel_), function(std::move(function_)), output_count(function.outputs.size()), promise(promise_) {
    InputSampler sampler(6, run_bands, Draw::hard);
    long double squares = 0;
    for (int i = 0; i < draws; ++i) {
      for (const long double x : run(cast<long double>(sampler.draw(function.parameters)))) squares += x * x;
    }
    typical = std::sqrt(squares / static_cast<long double>(output_count * draws));
  }

  template <class T>
  std::vector<T> run(const std::vector<T>& inputs) const {
    return kernel.run(inputs, output_count);
  }

  /// Inputs that T can hold, and what the kernel makes of just these in long double.
  template <class T>
  std::pair<std::vector<T>, std::vector<long double>> sample(InputSampler& sampler) const {
    const std::vector<T> inputs = cast<T>(sampler.draw(function.parameters));
    return {inputs, run(cast<long double>(inputs))};
  }

  /// Every output within so many epsilons of the unit.
  template <class T>
  void require_close(const std::vector<T>& outputs, const std::vector<long double>& expected, double epsilon_of) const {
    const long double unit = std::max(largest(expected), promise.unit == zonal::accuracy::kUlpOfLargest ? 0 : typical);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const long double error = std::abs(static_cast<long double>(outputs[i]) - expected[i]);
      if (error > 0) worst = std::max(worst, static_cast<double>(error / unit / static_cast<long double>(epsilon_of)));
      if (error <= static_cast<long double>(promise.common * epsilon_of) * unit) continue;
      CAPTURE(i, outputs[i], static_cast<double>(expected[i]), static_cast<double>(unit), worst);
      FAIL_CHECK("beyond the bound");
      return;
    }
  }

  const KernelRuns& kernel;
  RecordedFunction function;
  std::size_t output_count;
  Accuracy promise;
  long double typical = 0;
  mutable double worst = 0;  // seen, in ulps
};

template <class T>
void check_builtin(const Subject& subject) {
  InputSampler sampler(1, run_bands, Draw::hard);
  for (int i = 0; i < draws; ++i) {
    const auto [inputs, expected] = subject.sample<T>(sampler);
    CAPTURE(inputs);
    subject.require_close(subject.run(inputs), expected, epsilon<T>);
  }
}

template <class T, int W>
void check_packet(const Subject& subject) {
  using P = zonal::Packet<T, W>;
  InputSampler sampler(2, run_bands, Draw::hard);
  for (int i = 0; i < draws / W; ++i) {
    std::vector<P> inputs;
    std::vector<std::vector<long double>> expected;
    for (int lane = 0; lane < W; ++lane) {
      const auto lane_sample = subject.sample<T>(sampler);
      inputs.resize(lane_sample.first.size());
      for (std::size_t k = 0; k < inputs.size(); ++k) inputs[k].set(lane, lane_sample.first[k]);
      expected.push_back(lane_sample.second);
    }
    const std::vector<P> outputs = subject.run(inputs);
    for (int lane = 0; lane < W; ++lane) {
      std::vector<T> values;
      for (const P& output : outputs) values.push_back(output[lane]);
      CAPTURE(W, lane);
      subject.require_close(values, expected[static_cast<std::size_t>(lane)], epsilon<T>);
    }
  }
}

/// Derivatives by four inputs at a time, against differences in long double, for which ends of domains leave no room.
inline void check_dual(const Subject& subject) {
  constexpr std::size_t at_once = 4;
  InputSampler sampler(3, run_bands, Draw::ordinary);
  for (std::size_t i = 0; i < 40; ++i) {
    const auto [values, expected] = subject.sample<double>(sampler);
    std::vector<DoubleDual> inputs;
    for (const double value : values) inputs.push_back(DoubleDual(value));
    const std::size_t variables = std::min(at_once, values.size());
    const auto variable = [&](std::size_t k) { return (i * at_once + k) % values.size(); };
    for (std::size_t k = 0; k < variables; ++k) {
      inputs[variable(k)] = DoubleDual::variable(values[variable(k)], static_cast<int>(k));
    }
    CAPTURE(values);
    const std::vector<DoubleDual> outputs = subject.run(inputs);
    std::vector<double> value;
    for (const DoubleDual& output : outputs) value.push_back(output.value);
    subject.require_close(value, expected, epsilon<double>);
    for (std::size_t k = 0; k < variables; ++k) {
      const long double h = 1e-6L * std::max(std::abs(static_cast<long double>(values[variable(k)])), 1e-2L);
      auto above = cast<long double>(values), below = above;
      above[variable(k)] += h, below[variable(k)] -= h;
      const auto high = subject.run(above), low = subject.run(below);
      std::vector<long double> slope;
      for (std::size_t j = 0; j < high.size(); ++j) slope.push_back((high[j] - low[j]) / (2 * h));
      const long double unit = std::max(largest(slope), 1e-3L * subject.typical);
      for (std::size_t j = 0; j < slope.size(); ++j) {
        CAPTURE(j, variable(k), static_cast<double>(slope[j]), outputs[j].partial[k], static_cast<double>(unit));
        CHECK(std::abs(static_cast<long double>(outputs[j].partial[k]) - slope[j]) <= 1e-6L * unit);
      }
    }
  }
}

inline void check_shadow(const Subject& subject) {
  InputSampler sampler(4, run_bands, Draw::hard);
  for (int i = 0; i < draws; ++i) {
    const auto [inputs, expected] = subject.sample<float>(sampler);
    std::vector<FloatShadow> shadows;
    for (const float input : inputs) shadows.push_back(FloatShadow::input(input));
    CAPTURE(inputs);
    std::vector<float> narrow;
    std::vector<double> wide;
    for (const FloatShadow& output : subject.run(shadows)) {
      narrow.push_back(output.value);
      wide.push_back(output.wide);
    }
    // A series is as long as the narrow type needs, and each takes the same side of a choice.
    subject.require_close(wide, expected, epsilon<float> / 16);
    CHECK(narrow == subject.run(inputs));
  }
}

/// The record to the bit what C++ computes.
inline void check_record(const Subject& subject) {
  InputSampler sampler(5, run_bands, Draw::hard);
  for (int i = 0; i < draws; ++i) {
    const std::vector<float> inputs = cast<float>(sampler.draw(subject.function.parameters));
    const auto outputs = zonal::kernels::with_triples(subject.function.parameters, subject.run(inputs));
    require_equal(interpret(subject.function, inputs), kept_of(subject.function, outputs), true,
                  [&] { return inputs; });
  }
}
