// Every function's adjoint against dual numbers and differences, all inputs at once: along a direction in the space of
// the inputs, what the derivatives by the inputs come to is what the outputs' derivatives come to. That drivers compute
// the same: driver_functions_test.cpp.
#include <zonal/scalar/dual.hpp>
#include <zonal/shader/adjoint_function.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../catch.hpp"
#include "adjoints.hpp"
#include "inputs.hpp"
#include "interpret.hpp"
#include "shader_functions.hpp"

namespace {

using zonal::kernels::Draw;
using zonal::shader::all_orders;
using zonal::shader::FunctionEntry;
using zonal::shader::RecordedFunction;
using Dual = zonal::Dual<double, 1>;

template <class To, class From>
std::vector<To> cast(const std::vector<From>& from) {
  std::vector<To> to;
  for (const From& number : from) to.push_back(static_cast<To>(number));
  return to;
}

/// A function, its adjoint, and inputs of both: those of the function, then the derivatives by its outputs.
struct Subject {
  RecordedFunction function, adjoint;
  std::size_t inputs, outputs;

  Subject(const FunctionEntry& entry, int bands, RecordedFunction&& its_adjoint)
      : function(entry.record(bands, all_orders)), adjoint(std::move(its_adjoint)), inputs(0) {
    for (const auto& p : function.parameters) {
      if (p.direction == zonal::shader::Direction::in) inputs += static_cast<std::size_t>(p.size());
    }
    outputs = function.outputs.size();
  }

  std::vector<double> forward_inputs(const std::vector<double>& all) const {
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(inputs)};
  }

  /// The sum over outputs of the derivative by it times its slope, and the sum of magnitudes.
  template <class Slopes>
  std::pair<double, double> of_outputs(const std::vector<double>& all, const Slopes& slopes) const {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < outputs; ++k) {
      const double term = all[inputs + k] * static_cast<double>(slopes[k]);
      sum += term, size += std::abs(term);
    }
    return {sum, size};
  }
  /// The same by the adjoint: over inputs, of the derivative by it times the direction. Inputs that have none are 0.
  std::pair<double, double> of_inputs(const std::vector<double>& all, const std::vector<double>& direction) const {
    const std::vector<double> results = interpret(adjoint, all);
    double sum = 0, size = 0;
    std::size_t input = 0, result = outputs;
    for (const auto& p : function.parameters) {
      if (p.direction != zonal::shader::Direction::in) continue;
      const std::string by = "by_" + std::string(p.name);
      const bool is_there = std::any_of(adjoint.parameters.begin(), adjoint.parameters.end(), [&](const auto& other) {
        return other.direction == zonal::shader::Direction::out && other.name == by;
      });
      for (int i = 0; i < p.size(); ++i, ++input) {
        const double term = is_there ? results[result++] * direction[input] : 0;
        sum += term, size += std::abs(term);
      }
    }
    return {sum, size};
  }
};

/// check(subject, all inputs, a direction) for every function that has an adjoint, at 2 and 3 bands.
template <class Check>
void for_every_adjoint(Draw draw, int draws, Check check) {
  int count = 0;
  for (const FunctionEntry& entry : zonal_glsl::shader_functions()) {
    for (const int bands : {2, 3}) {
      auto adjoint = adjoint_of(entry, bands);
      if (!adjoint || (!entry.has_bands && bands > 2)) continue;
      const Subject subject(entry, bands, std::move(*adjoint));
      INFO(subject.adjoint.name);
      zonal::kernels::InputSampler sampler(12, bands, draw);
      std::mt19937 random(13);
      std::normal_distribution<double> normal;
      for (int i = 0; i < draws; ++i) {
        const std::vector<double> inputs = sampler.draw(subject.adjoint.parameters);
        std::vector<double> direction(subject.inputs);
        for (double& x : direction) x = normal(random);
        CAPTURE(inputs, direction);
        check(subject, inputs, direction);
      }
      ++count;
    }
  }
  CHECK(count > 100);
}

}  // namespace

TEST_CASE("The adjoint of every function is what dual numbers say") {
  for_every_adjoint(Draw::hard, 100, [](const Subject& subject, const auto& inputs, const auto& direction) {
    std::vector<Dual> duals;
    for (std::size_t i = 0; i < subject.inputs; ++i) duals.push_back(Dual(inputs[i], {direction[i]}));
    std::vector<double> slopes;
    for (const Dual& output : interpret(subject.function, duals)) slopes.push_back(output.partial[0]);
    const auto [expected, size] = subject.of_outputs(inputs, slopes);
    const auto [found, parts] = subject.of_inputs(inputs, direction);
    CAPTURE(expected, found, size, parts);
    REQUIRE(std::abs(found - expected) <= 1e-12 * (size + parts));
  });
}

TEST_CASE("The adjoint of every function is what differences say") {
  for_every_adjoint(Draw::ordinary, 20, [](const Subject& subject, const auto& inputs, const auto& direction) {
    constexpr long double h = 1e-7L;
    auto above = cast<long double>(subject.forward_inputs(inputs)), below = above;
    for (std::size_t i = 0; i < above.size(); ++i) above[i] += h * direction[i], below[i] -= h * direction[i];
    const auto high = interpret(subject.function, above), low = interpret(subject.function, below);
    std::vector<long double> slopes;
    for (std::size_t k = 0; k < high.size(); ++k) slopes.push_back((high[k] - low[k]) / (2 * h));
    const auto [expected, size] = subject.of_outputs(inputs, slopes);
    const auto [found, parts] = subject.of_inputs(inputs, direction);
    const double rounding = 1e-12 * subject.of_outputs(inputs, high).second;  // of the outputs, over 2 h
    CAPTURE(expected, found, size, parts, rounding);
    REQUIRE(std::abs(found - expected) <= 1e-7 * (size + parts) + rounding);
  });
}

TEST_CASE("Only what is asked for is derived, and what cannot be is refused by name") {
  const FunctionEntry& entry = *zonal_glsl::find_function("splat_colour");
  const auto adjoint = [&](const std::vector<std::string>& by) {
    return zonal::shader::adjoint_function(entry.record(4, all_orders), by);
  };
  const auto names = [](const RecordedFunction& function) {
    std::string all;
    for (const auto& p : function.parameters) all += std::string(p.name) + " ";
    return all;
  };
  CHECK(names(adjoint({})) == "sh position camera value by_value by_sh by_position by_camera ");
  CHECK(names(adjoint({"position"})) == "sh position camera value by_value by_position ");
  CHECK(adjoint({"sh"}).count().total() < adjoint({"position"}).count().total());
  CHECK(adjoint({"position"}).count().total() < adjoint({"position", "sh"}).count().total());
  CHECK_THROWS_WITH(adjoint({"normal"}), "zonal_splat_colour_4 has no input 'normal', but sh, position, camera");
  const auto refusal = [](const char* name, const std::vector<std::string>& by) {
    try {
      zonal::shader::adjoint_function(zonal_glsl::find_function(name)->record(3, all_orders), by);
    } catch (const zonal::shader::NoAdjoint& none) {
      return std::string(none.what());
    }
    return std::string();
  };
  CHECK(refusal("lambert", {}) == "zonal_lambert_3 has no inputs");
  CHECK(refusal("add_sphere", {}) == "zonal_add_sphere_3 adds to what it is given, which has no adjoint here");
  CHECK(refusal("is_same_surface", {}) == "zonal_is_same_surface has no derivative by any input");
  CHECK(refusal("is_same_surface", {"depth_a"}) == "zonal_is_same_surface does not change with 'depth_a'");
}

TEST_CASE("The kernel with derivatives is the adjoint of the one without, in no more operations") {
  for (const auto& [forward, kernel] :
       {std::pair("reconstruct_along_colour", "reconstruct_with_adjoint"), {"splat_colour", "splat_with_adjoint"}}) {
    for (int bands = 1; bands <= std::min(6, zonal::shader::max_bands); ++bands) {
      const bool is_splat = std::string_view(forward) == "splat_colour";
      const RecordedFunction swept = zonal::shader::adjoint_function(
          zonal_glsl::find_function(forward)->record(bands, all_orders),
          bands == 1 ? std::vector<std::string>{"sh"}
                     : std::vector<std::string>{"sh", is_splat ? "position" : "direction"});
      const RecordedFunction fused = zonal_glsl::find_function(kernel)->record(bands, all_orders);
      CAPTURE(kernel, bands);
      CHECK(fused.count().total() <= swept.count().total());

      zonal::kernels::InputSampler sampler(14, bands, Draw::hard);
      for (int i = 0; i < 200; ++i) {
        const std::vector<double> inputs = sampler.draw(fused.parameters);
        auto swept_inputs = inputs;
        if (is_splat) swept_inputs.insert(swept_inputs.end() - 3, 3, 0.0);  // the camera
        const auto found = interpret(fused, inputs), expected = interpret(swept, swept_inputs);
        double largest = 1;  // what coefficients and vectors are
        for (const double x : expected) largest = std::max(largest, std::abs(x));
        for (std::size_t k = 0; k < expected.size(); ++k) {
          CAPTURE(inputs, k, found[k], expected[k]);
          // Computed in double, but from constants in float, which differ; sums have so many terms.
          REQUIRE(std::abs(found[k] - expected[k]) <= 6e-8 * bands * bands * largest);
        }
      }
    }
  }
}

TEST_CASE("A colour along a vector and its derivatives take few operations") {
  const auto count = [](const char* name, int bands) {
    return zonal_glsl::find_function(name)->record(bands, all_orders).count().total();
  };
  // At a unit vector, as tests/scalar/adjoint_test.cpp counts it, it is 24 less: 309 and 160.
  CHECK(count("reconstruct_with_adjoint", 4) == 333);
  CHECK(count("reconstruct_with_adjoint", 3) == 184);
  CHECK(count("splat_with_adjoint", 4) == 345);
}
