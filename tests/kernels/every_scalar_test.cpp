// Every kernel in every scalar, against itself in long double, which the rooms' tests set against definitions.
// Compiled without fused multiplication and addition, so that records can be compared to the bit.
#include "kernels.hpp"

#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/scalar/shadow.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "../catch.hpp"
#include "interpreter.hpp"

namespace {

using zonal::Horizon;

template <class Kernel, class T>
std::vector<T> run(const std::vector<T>& inputs) {
  std::vector<T> outputs;
  Kernel::run(inputs, outputs);
  return outputs;
}

template <class To, class From>
std::vector<To> cast(const std::vector<From>& from) {
  std::vector<To> to;
  for (const From& value : from) to.push_back(static_cast<To>(value));
  return to;
}

template <class T>
long double largest(const std::vector<T>& values) {
  long double result = 0;
  for (const T& value : values) result = std::max(result, std::abs(static_cast<long double>(value)));
  return result;
}

/// Every output within `tolerance` of the largest expected one.
template <class T>
void require_close(const std::vector<T>& outputs, const std::vector<long double>& expected, double tolerance) {
  REQUIRE(outputs.size() == expected.size());
  const long double unit = largest(expected);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    CAPTURE(i, outputs[i], static_cast<double>(expected[i]), static_cast<double>(unit));
    REQUIRE(std::abs(static_cast<long double>(outputs[i]) - expected[i]) <= tolerance * unit);
  }
}

template <class T>
constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

/// Inputs that T can hold, and what the kernel makes of just these in long double.
template <class Kernel, class T>
std::pair<std::vector<T>, std::vector<long double>> sample(kernels::Sampler& sampler) {
  const std::vector<T> inputs = cast<T>(Kernel::sample(sampler));
  return {inputs, run<Kernel>(cast<long double>(inputs))};
}

template <class Kernel, class T>
void check_builtin() {
  kernels::Sampler sampler(1);
  for (int i = 0; i < 500; ++i) {
    const auto [inputs, expected] = sample<Kernel, T>(sampler);
    CAPTURE(inputs);
    require_close(run<Kernel>(inputs), expected, Kernel::ulps * epsilon<T>);
  }
}

template <class Kernel, class T, int W>
void check_packet() {
  using P = zonal::Packet<T, W>;
  kernels::Sampler sampler(2);
  std::vector<P> inputs(Kernel::sample(sampler).size());
  std::vector<std::vector<long double>> expected;
  for (int lane = 0; lane < W; ++lane) {
    const auto lane_sample = sample<Kernel, T>(sampler);
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i].set(lane, lane_sample.first[i]);
    expected.push_back(lane_sample.second);
  }
  const std::vector<P> outputs = run<Kernel>(inputs);
  for (int lane = 0; lane < W; ++lane) {
    std::vector<T> values;
    for (const P& output : outputs) values.push_back(output[lane]);
    CAPTURE(W, lane);
    require_close(values, expected[static_cast<std::size_t>(lane)], Kernel::ulps * epsilon<T>);
  }
}

template <class Kernel, int K>
void check_dual() {
  using D = zonal::Dual<double, K>;
  kernels::Sampler sampler(3);
  for (int i = 0; i < 50; ++i) {
    const auto [values, expected] = sample<Kernel, double>(sampler);
    REQUIRE(values.size() == K);
    std::vector<D> inputs;
    for (int k = 0; k < K; ++k) inputs.push_back(D::variable(values[static_cast<std::size_t>(k)], k));
    CAPTURE(values);
    const std::vector<D> outputs = run<Kernel>(inputs);

    std::vector<double> value;
    for (const D& output : outputs) value.push_back(output.value);
    require_close(value, expected, Kernel::ulps * epsilon<double>);
    for (std::size_t k = 0; k < K; ++k) {
      const long double h = 1e-6L * std::max(std::abs(static_cast<long double>(values[k])), 1e-2L);
      auto above = cast<long double>(values), below = above;
      above[k] += h, below[k] -= h;
      const auto high = run<Kernel>(above), low = run<Kernel>(below);
      std::vector<long double> slope;
      std::vector<double> partial;
      for (std::size_t j = 0; j < high.size(); ++j) {
        slope.push_back((high[j] - low[j]) / (2 * h));
        partial.push_back(outputs[j].partial[k]);
      }
      CAPTURE(k);
      require_close(partial, slope, 1e-6);
    }
  }
}

template <class Kernel>
void check_shadow() {
  using S = zonal::Shadow<float, double>;
  kernels::Sampler sampler(4);
  for (int i = 0; i < 500; ++i) {
    const auto [inputs, expected] = sample<Kernel, float>(sampler);
    std::vector<S> shadows;
    for (const float input : inputs) shadows.push_back(S::input(input));
    CAPTURE(inputs);
    std::vector<float> narrow;
    std::vector<double> wide;
    for (const S& output : run<Kernel>(shadows)) {
      narrow.push_back(output.value);
      wide.push_back(output.wide);
    }
    // A series is as long as the narrow type needs, and each takes the same side of a choice.
    require_close(wide, expected, Kernel::ulps * epsilon<float> / 16);
    CHECK(narrow == run<Kernel>(inputs));
  }
}

template <class Kernel>
void check_recorder() {
  kernels::Sampler sampler(5);
  zonal::Recording recording;
  std::vector<zonal::Recorder> inputs;
  for (std::size_t i = 0; i < Kernel::sample(sampler).size(); ++i) inputs.push_back(recording.input("input"));
  const std::vector<zonal::Recorder> outputs = run<Kernel>(inputs);
  for (int i = 0; i < 500; ++i) {
    const std::vector<float> sample = cast<float>(Kernel::sample(sampler));
    const std::vector<float> values = interpret(recording, sample);
    const std::vector<float> expected = run<Kernel>(sample);
    REQUIRE(outputs.size() == expected.size());
    CAPTURE(sample);
    for (std::size_t j = 0; j < outputs.size(); ++j) {
      std::uint32_t bits[2];
      const float recorded = value_of(outputs[j], values);
      std::memcpy(&bits[0], &recorded, sizeof recorded);
      std::memcpy(&bits[1], &expected[j], sizeof recorded);
      CAPTURE(j, recorded, expected[j]);
      REQUIRE(bits[0] == bits[1]);
    }
  }
}

template <class Kernel, int K>
void check_every_scalar() {
  CAPTURE(Kernel::name);
  SECTION(std::string(Kernel::name) + " in float and double") {
    check_builtin<Kernel, float>();
    check_builtin<Kernel, double>();
  }
  SECTION(std::string(Kernel::name) + " in packets") {
    check_packet<Kernel, float, 8>();
    check_packet<Kernel, double, 4>();
  }
  SECTION(std::string(Kernel::name) + " in dual numbers") { check_dual<Kernel, K>(); }
  SECTION(std::string(Kernel::name) + " in shadow pairs") { check_shadow<Kernel>(); }
  SECTION(std::string(Kernel::name) + " recorded, to the bit") { check_recorder<Kernel>(); }
}

}  // namespace

TEST_CASE("The kernels of the basis, in every scalar") {
  check_every_scalar<kernels::Evaluate, 3>();
  check_every_scalar<kernels::EvaluateEven, 2>();
  check_every_scalar<kernels::EvaluateZonal, 1>();
  check_every_scalar<kernels::EvaluateWithGradient, 3>();
}

TEST_CASE("The kernels of the lobes, in every scalar") {
  check_every_scalar<kernels::Cap, 2>();
  check_every_scalar<kernels::SphereCap, 2>();
  check_every_scalar<kernels::CapDerivative, 2>();
  check_every_scalar<kernels::Lambert, 0>();
  check_every_scalar<kernels::Phong, 1>();
  check_every_scalar<kernels::Gaussian, 1>();
}

TEST_CASE("The kernels of the transforms, in every scalar") {
  check_every_scalar<kernels::Orient, 8>();
  check_every_scalar<kernels::ConvolveAndDot, 23>();
}

TEST_CASE("Arcs and horizons, in every scalar") {
  check_every_scalar<kernels::Arcs, 2>();
  check_every_scalar<kernels::HorizonOf<Horizon::smoothstep>, 3>();
  check_every_scalar<kernels::HorizonOf<Horizon::exact>, 3>();
}

TEST_CASE("The kernels of the lights, in every scalar") {
  check_every_scalar<kernels::ProjectWithGradient<kernels::Sphere>, 3>();
  check_every_scalar<kernels::ProjectWithGradient<kernels::Spot>, 3>();
  check_every_scalar<kernels::ProjectWithGradient<kernels::TriangleSphere>, 3>();
  check_every_scalar<kernels::Polygon, 3>();
}

TEST_CASE("The gather's kernel, in every scalar") {
  check_every_scalar<kernels::HvlRadiance<Horizon::smoothstep>, 4>();
  check_every_scalar<kernels::HvlRadiance<Horizon::exact>, 4>();
}
