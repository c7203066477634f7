// The reverse sweep of a recording: every operation against dual numbers, and what it takes. Every kernel of the
// registry: shader/adjoint_test.cpp.
#include <zonal/basis/evaluate.hpp>
#include <zonal/scalar/adjoint.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/transform/dot.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../catch.hpp"
#include "../shader/interpret.hpp"

namespace {

using zonal::Recorder;
using zonal::Recording;
using Dual = zonal::Dual<double, 3>;

/// Functions of three numbers that use every operation, the same operand twice, constants, and both sides of choices.
template <class T>
std::array<T, 4> functions(const T& x, const T& y, const T& z) {
  const T product = x * y * x, quotient = (y - x) / (z * z + T(2)), inverse = T(1) / (x * x + T(1));
  const T chosen = select(x < y, product, -quotient), other = select(y <= z, T(3) / (y * y + T(1)), x * T(0.25));
  return {product + quotient - inverse * maximum(x, y), minimum(x * z, y) * maximum(z, T(0.5)) + abs(x - z),
          sqrt(x * x + y * y + T(0.125)) * chosen, other - abs(z) * sqrt(abs(y) + T(1)) + minimum(x, T(0))};
}

}  // namespace

TEST_CASE("The sweep of every operation gives what dual numbers give") {
  Recording recording;
  const std::vector<Recorder> inputs{recording.input("x"), recording.input("y"), recording.input("z")};
  std::vector<Recorder> by_outputs;
  for (int k = 0; k < 4; ++k) by_outputs.push_back(recording.input("by"));
  const auto outputs = functions(inputs[0], inputs[1], inputs[2]);
  const auto by_inputs = adjoints(recording, {outputs.begin(), outputs.end()}, by_outputs, inputs);

  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> numbers(7);
    for (double& number : numbers) number = uniform(random);
    if (i % 10 == 0) numbers[1] = numbers[0];  // where choices are even
    if (i % 15 == 0) numbers[2] = numbers[1];
    if (i % 20 == 0) numbers[0] = 0;
    const auto found = values_of(by_inputs, run_lines(recording, numbers));
    const auto duals =
        functions(Dual::variable(numbers[0], 0), Dual::variable(numbers[1], 1), Dual::variable(numbers[2], 2));
    for (std::size_t k = 0; k < 3; ++k) {
      double expected = 0, size = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        expected += numbers[3 + j] * duals[j].partial[k];
        size += std::abs(numbers[3 + j] * duals[j].partial[k]);
      }
      CAPTURE(numbers, k, found[k], expected);
      REQUIRE(std::abs(found[k] - expected) <= 20 * std::numeric_limits<double>::epsilon() * (size + 1));
    }
  }
}

TEST_CASE("What is not asked for is not derived, and what does not change has the derivative 0") {
  Recording recording;
  const Recorder x = recording.input("x"), y = recording.input("y"), by = recording.input("by");
  const Recorder f = x * x * y;
  const std::size_t before = recording.lines().size();
  const auto by_x = adjoints(recording, {f, Recorder(2)}, {by, by}, {x});
  CHECK(recording.count(by_x.begin(), by_x.end()).total() == 3);  // (by y + by y) x
  CHECK(recording.lines().size() == before + 3);
  const auto by_none = adjoints(recording, {select(x < y, Recorder(1), Recorder(0))}, {by}, {x, y});
  for (const Recorder& derivative : by_none) {
    REQUIRE(derivative.is_constant());
    CHECK(derivative.constant() == 0);
  }
}

TEST_CASE("The root of 0 has an infinite derivative, but hands on nothing where it was not chosen") {
  Recording recording;
  const Recorder x = recording.input("x"), by = recording.input("by");
  const Recorder root = sqrt(x), chosen = select(Recorder(0) < x, root * x, x + x);
  const auto at_0 = [&](const Recorder& output) {
    const auto by_x = adjoints(recording, {output}, {by}, {x});
    return values_of(by_x, run_lines(recording, std::vector<double>{0, 1}))[0];
  };
  CHECK(at_0(root) == std::numeric_limits<double>::infinity());
  CHECK(at_0(chosen) == 2);
}

// What a colour of three channels takes with its derivatives, at a unit vector: the figures that were asked for are 330
// operations at 4 bands and 170 at 3, and a trial had come to 322 and 164.
TEST_CASE("Value and derivatives of a colour share what they have in common") {
  const auto operations = [](auto bands) {
    constexpr int N = bands;
    Recording recording;
    const std::array<Recorder, 3> direction{recording.input("x"), recording.input("y"), recording.input("z")};
    std::vector<Recorder> inputs(direction.begin(), direction.end()), asked, by_colour;
    for (int channel = 0; channel < 3; ++channel) {
      zonal::Sh<N, Recorder> sh;
      for (Recorder& coefficient : sh) inputs.push_back(coefficient = recording.input("coefficient"));
      asked.push_back(zonal::reconstruct(sh, direction));
      by_colour.push_back(recording.input("by"));
    }
    const auto derivatives = adjoints(recording, asked, by_colour, inputs);
    asked.insert(asked.end(), derivatives.begin(), derivatives.end());
    return recording.count(asked.begin(), asked.end()).total();
  };
  CHECK(operations(zonal::Index<3>{}) == 162);
  CHECK(operations(zonal::Index<4>{}) == 319);
  CHECK(operations(zonal::Index<5>{}) == 524);
}
