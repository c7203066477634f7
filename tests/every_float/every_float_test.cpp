// Functions of one variable, at every float of their range: one in some hundreds in the test command, and all of them
// by
//   ZONAL_EVERY_FLOAT=1 test_every_float
// which takes an hour. The exact value is that of the same kernel, or of the standard library, in double.
#include <zonal/kernels/basis_kernels.hpp>
#include <zonal/kernels/lobe_kernels.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/kernels/transform_kernels.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

using namespace zonal::kernels;

double ulp(double value) {
  const float magnitude = std::abs(static_cast<float>(value));
  return static_cast<double>(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) -
         static_cast<double>(magnitude);
}
double ratio(double difference, double unit) { return difference == 0 ? 0 : std::abs(difference) / unit; }

struct Worst {
  double error = 0;
  float at = 0;
  std::uint64_t count = 0;
};

/// The greatest error(x) of the floats from low to high, 0 <= low, each `stride`-th from low on, and of their
/// negatives. One that is no number is infinite.
template <class Error>
Worst worst_of(float low, float high, std::uint32_t stride, bool with_negatives, Error error) {
  Worst worst;
  const auto meet = [&](float x) {
    const double e = error(x);
    ++worst.count;
    if (!(e <= worst.error)) worst.error = std::isnan(e) ? std::numeric_limits<double>::infinity() : e, worst.at = x;
  };
  const auto last = std::bit_cast<std::uint32_t>(high);
  for (std::uint64_t bits = std::bit_cast<std::uint32_t>(low); bits <= last; bits += stride) {
    const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    meet(x);
    if (with_negatives) meet(-x);
  }
  return worst;
}

/// `stride`: what the test command can afford; a prime, lest low bits are always the same.
template <class Error>
void check(std::string_view function, int bands, float low, float high, std::uint32_t stride, bool with_negatives,
           Error error) {
  const bool is_all = std::getenv("ZONAL_EVERY_FLOAT") != nullptr;
  const Worst worst = worst_of(low, high, is_all ? 1 : stride, with_negatives, error);
  const Accuracy promise = accuracy_of(function, "float", bands);
  if (is_all) {
    std::printf("%s %d: %.6g at %a, of %llu floats; kept %.6g\n", std::string(function).c_str(), bands, worst.error,
                static_cast<double>(worst.at), static_cast<unsigned long long>(worst.count), promise.worst);
    std::fflush(stdout);
  }
  CAPTURE(function, bands, worst.at, worst.count);
  if (promise.worst_input.find(' ') == std::string_view::npos) {
    const double kept = error(std::strtof(std::string(promise.worst_input).c_str(), nullptr));
    CHECK(kept <= 1.01 * promise.worst);
    CHECK(kept >= 0.99 * promise.worst);
  }
  CHECK(worst.error <= 1.001 * promise.worst);
  CHECK(worst.error <= promise.bound);
}

/// Against the largest coefficient, or the degree's.
template <class Entry, int N, std::size_t inputs>
double kernel_error(const std::array<float, inputs>& numbers, bool is_of_the_degree) {
  std::array<double, inputs> exact_numbers;
  for (std::size_t i = 0; i < inputs; ++i) exact_numbers[i] = static_cast<double>(numbers[i]);
  float outputs[std::size_t{N}];
  double exact[std::size_t{N}], largest = 0, worst = 0;
  run_plainly<Entry, N>(numbers.data(), outputs);
  run_plainly<Entry, N>(exact_numbers.data(), exact);
  for (const double z : exact) largest = (std::max)(largest, std::abs(z));
  for (int l = 0; l < N; ++l) {
    const double unit = is_of_the_degree ? std::sqrt((2 * l + 1) / 12.566370614359172954) : largest;
    const double error = std::abs(static_cast<double>(outputs[l]) - exact[l]) / unit;
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

template <class Entry, int N>
void check_kernel(float low, float high, std::uint32_t stride, bool is_of_the_degree = false) {
  check(Entry::name, N, low, high, stride, is_of_the_degree,
        [&](float x) { return kernel_error<Entry, N, 1>({x}, is_of_the_degree); });
}
/// A cap by its sine, the cosine rounded.
template <class Entry, int N>
void check_cap(std::uint32_t stride) {
  check(Entry::name, N, 1e-12F, 1, stride, true, [](float x) {
    const double sine = std::abs(static_cast<double>(x)), cosine = std::sqrt((1 - sine) * (1 + sine));
    const bool is_beyond = x < 0 && Entry::name != std::string_view("cap_up_to_hemisphere");
    return kernel_error<Entry, N, 2>({static_cast<float>(is_beyond ? -cosine : cosine), std::abs(x)}, false);
  });
}

}  // namespace

TEST_CASE("every float: asin and acos") {
  check("asin", 0, 0, 1, 211, true, [](float x) {
    const double exact = std::asin(static_cast<double>(x));
    return ratio(static_cast<double>(zonal::asin(x)) - exact, ulp(exact));
  });
  check("acos", 0, 0, 1, 211, true, [](float x) {
    const double exact = std::acos(static_cast<double>(x));
    return ratio(static_cast<double>(zonal::acos(x)) - exact, ulp(3.14159265358979323846));
  });
}

TEST_CASE("every float: angle_from, sine and cosine of every angle") {
  check("angle_from", 0, 0, 1, 211, true, [](float x) {
    const double sine = std::abs(static_cast<double>(x));
    const auto cosine = static_cast<float>(std::copysign(std::sqrt((1 - sine) * (1 + sine)), static_cast<double>(x)));
    const double exact = std::atan2(sine, static_cast<double>(cosine));
    return ratio(static_cast<double>(zonal::angle_from(cosine, std::abs(x))) - exact, ulp(3.14159265358979323846));
  });
  check("sin_cos", 0, 0, 1.57079632679F, 211, true, [](float x) {
    const auto found = zonal::sin_cos(x);
    const double angle = static_cast<double>(x);
    return (std::max)(std::abs(static_cast<double>(found.sine) - std::sin(angle)),
                      std::abs(static_cast<double>(found.cosine) - std::cos(angle))) /
           ulp(1);
  });
}

TEST_CASE("every float: exp") {
  const auto error = [](float x) {
    const double exact = std::exp(static_cast<double>(x));
    return ratio(static_cast<double>(zonal::exp(x)) - exact, ulp(exact));
  };
  check("exp", 0, 0, 87.3365F, 101, true, error);
  check("exp", 0, 87.3365F, 88.7228F, 101, false, error);  // the least result would be no normal number
}

TEST_CASE("every float: the zonal basis by the cosine") {
  check_kernel<EvaluateZonal, 5>(0, 1, 211, true);
  check_kernel<EvaluateZonal, 10>(0, 1, 401, true);
}

TEST_CASE("every float: caps by the sine") {
  check_cap<Cap, 5>(401);
  check_cap<Cap, 10>(1009);
  check_cap<HemisphereCap, 5>(401);
  check_cap<HemisphereCap, 10>(1009);
  check_cap<CapDerivative, 5>(401);
  check_cap<CapDerivative, 10>(1009);
}

TEST_CASE("every float: Phong's lobe by the exponent") {
  check_kernel<Phong, 5>(0, 1024, 401);
  check_kernel<Phong, 10>(0, 1024, 1009);
}

TEST_CASE("every float: the Gaussian by its sharpness") {
  check_kernel<Gaussian, 5>(0, 0x1p20F, 2003);
  check_kernel<Gaussian, 10>(0, 0x1p20F, 4001);
}

TEST_CASE("every float: windows by their width") {
  check_kernel<WindowFactors<zonal::Window::hann>, 10>(0.5F, 1024, 401);
  check_kernel<WindowFactors<zonal::Window::sinc>, 10>(0.5F, 1024, 401);
}
