// The promises of the accuracy table for the inverse trigonometry, in float, double and packets.
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/math.hpp>
#include <zonal/scalar/packet.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string_view>
#include <type_traits>
#include <vector>

#include "../accuracy.hpp"
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "../catch.hpp"

namespace {

constexpr long double pi = 3.14159265358979323846264338327950288L;

template <class T>
long double ulp(long double value) {
  const T magnitude = std::abs(static_cast<T>(value));
  return static_cast<long double>(std::nextafter(magnitude, std::numeric_limits<T>::infinity())) -
         static_cast<long double>(magnitude);
}

/// -1 to 1: uniform, at every power of two below 1, and at every such distance from 1/2 and 1, on either side of 0.
template <class T>
std::vector<T> sines() {
  std::vector<T> values{T(0), T(0.5), T(1)};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 200000; ++i) {
    const double small = std::exp2(-30 * uniform(random)), u = uniform(random);
    for (const double v : {u, small, 0.5 - small / 2, 0.5 + small / 2, 1 - small}) values.push_back(static_cast<T>(v));
  }
  const std::size_t half = values.size();
  for (std::size_t i = 0; i < half; ++i) values.push_back(-values[i]);
  while (values.size() % 16 != 0) values.push_back(T(1));
  return values;
}

template <class T>
struct Worst {
  long double error = 0;
  T input{};
  void meet(long double e, T at) {
    if (!(e <= error)) error = e, input = at;
  }
};

/// f in groups of S::width lanes, or one by one.
template <class S, class T, class F>
std::vector<T> map(const std::vector<T>& inputs, F f) {
  std::vector<T> results(inputs.size());
  if constexpr (std::is_same_v<S, T>) {
    for (std::size_t i = 0; i < inputs.size(); ++i) results[i] = f(inputs[i]);
  } else {
    for (std::size_t i = 0; i < inputs.size(); i += S::width) f(S::load(&inputs[i])).store(&results[i]);
  }
  return results;
}

template <class S, class T>
constexpr std::string_view name = std::is_same_v<S, T> ? scalar_name<T> : packet_name<T>;

/// Sines, and what asin and acos are to make of them: the same for all widths of packets.
template <class T>
struct InverseSines {
  std::vector<T> inputs = sines<T>();
  std::vector<long double> asins, acoses;
  InverseSines() {
    for (const long double x : inputs) asins.push_back(std::asin(x)), acoses.push_back(std::acos(x));
  }
};
template <class T>
const InverseSines<T>& inverse_sines() {
  static const InverseSines<T> all;
  return all;
}

template <class S, class T>
void check_inverse_sines() {
  const InverseSines<T>& exact = inverse_sines<T>();
  const std::vector<T>& inputs = exact.inputs;
  const auto asins = map<S>(inputs, [](const auto& x) { return zonal::asin(x); });
  const auto acoses = map<S>(inputs, [](const auto& x) { return zonal::acos(x); });
  Worst<T> asin_error, acos_error;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    asin_error.meet(std::abs(static_cast<long double>(asins[i]) - exact.asins[i]) / ulp<T>(exact.asins[i]), inputs[i]);
    acos_error.meet(std::abs(static_cast<long double>(acoses[i]) - exact.acoses[i]) / ulp<T>(pi), inputs[i]);
  }
  const std::string_view row = name<S, T>;
  CAPTURE(row, sizeof(S) / sizeof(T), asin_error.input, acos_error.input);
  CHECK(asin_error.error <= accuracy_bound("asin", row));
  CHECK(acos_error.error <= accuracy_bound("acos", row));
}

template <class S, class T>
void check_angles() {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform;
  Worst<T> worst;
  std::array<T, 16> cosines, sines_, results;
  for (int i = 0; i < 40000; ++i) {
    for (std::size_t lane = 0; lane < 16; ++lane) {
      const double small = std::exp2(-40 * uniform(random)), quarter = static_cast<double>(pi) / 2;
      const double offset = lane % 2 ? small : quarter * uniform(random);
      const double angle = lane % 8 < 2   ? offset
                           : lane % 8 < 4 ? 2 * quarter - offset
                           : lane % 8 < 6 ? quarter - offset
                                          : quarter + offset;
      cosines[lane] = static_cast<T>(std::cos(angle));
      sines_[lane] = static_cast<T>(std::sin(angle));
    }
    if constexpr (std::is_same_v<S, T>) {
      for (std::size_t lane = 0; lane < 16; ++lane) results[lane] = zonal::angle_from(cosines[lane], sines_[lane]);
    } else {
      for (std::size_t lane = 0; lane < 16; lane += S::width) {
        zonal::angle_from(S::load(&cosines[lane]), S::load(&sines_[lane])).store(&results[lane]);
      }
    }
    for (std::size_t lane = 0; lane < 16; ++lane) {
      const long double exact =
          std::atan2(static_cast<long double>(sines_[lane]), static_cast<long double>(cosines[lane]));
      worst.meet(std::abs(static_cast<long double>(results[lane]) - exact) / ulp<T>(pi), cosines[lane]);
    }
  }
  const std::string_view row = name<S, T>;
  CAPTURE(row, sizeof(S) / sizeof(T), worst.input);
  CHECK(worst.error <= accuracy_bound("angle_from", row));
}

template <class S, class T>
void check_small_angles() {
  for (int i = 1; i < 36; ++i) {
    const T angle = static_cast<T>(std::exp2(-i));
    const T cosine = std::cos(angle), sine = std::sin(angle);
    const S result = zonal::angle_from(S(cosine), S(sine));
    T value;
    if constexpr (std::is_same_v<S, T>)
      value = result;
    else
      value = result[0];
    CAPTURE(i);
    CHECK(std::abs(static_cast<long double>(value) - static_cast<long double>(angle)) <= 3 * ulp<T>(angle));
  }
}

/// Where the result is a normal number; near 0, and on either side of each power of two.
template <class S, class T>
void check_exponentials() {
  std::vector<T> inputs;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform;
  const double greatest = std::log(static_cast<double>(std::numeric_limits<T>::max()));
  for (int i = 0; i < 100000; ++i) {
    const double near_power = std::exp2(std::floor(12 * uniform(random) - 3)) * (1 + 1e-6 * (uniform(random) - 0.5));
    for (const double x :
         {greatest * uniform(random), 4 * uniform(random), std::exp2(-30 * uniform(random)), near_power}) {
      if (x > 0.98 * greatest) continue;
      inputs.push_back(static_cast<T>(x));
      inputs.push_back(static_cast<T>(-x));
    }
  }
  while (inputs.size() % 16 != 0) inputs.push_back(T(0));
  const auto results = map<S>(inputs, [](const auto& x) { return zonal::exp(x); });
  Worst<T> worst, worst_small;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const long double exact = std::exp(static_cast<long double>(inputs[i]));
    const long double error = std::abs(static_cast<long double>(results[i]) - exact) / ulp<T>(exact);
    (std::abs(inputs[i]) < 1 ? worst_small : worst).meet(error, inputs[i]);
  }
  const std::string_view row = name<S, T>;
  CAPTURE(row, sizeof(S) / sizeof(T), worst.error, worst.input, worst_small.error, worst_small.input);
  CHECK(worst.error <= accuracy_bound("exp", row));
  CHECK(worst_small.error <= worst.error);
}

using zonal::Packet;

}  // namespace

TEST_CASE("asin and acos are as accurate as promised") {
  check_inverse_sines<float, float>();
  check_inverse_sines<double, double>();
  check_inverse_sines<Packet<float, 4>, float>();
  check_inverse_sines<Packet<float, 8>, float>();
  check_inverse_sines<Packet<float, 16>, float>();
  check_inverse_sines<Packet<double, 2>, double>();
  check_inverse_sines<Packet<double, 4>, double>();
  check_inverse_sines<Packet<double, 8>, double>();
}

TEST_CASE("angle_from is as accurate as promised at every angle") {
  check_angles<float, float>();
  check_angles<double, double>();
  check_angles<Packet<float, 8>, float>();
  check_angles<Packet<float, 16>, float>();
  check_angles<Packet<double, 4>, double>();
  check_angles<Packet<double, 8>, double>();
}

TEST_CASE("angle_from keeps the relative accuracy of small angles") {
  check_small_angles<float, float>();
  check_small_angles<double, double>();
  check_small_angles<Packet<float, 8>, float>();
}

TEST_CASE("asin, acos and angle_from at their ends") {
  CHECK(zonal::asin(0.0) == 0);
  CHECK(zonal::asin(1.0) == Catch::Approx(static_cast<double>(pi / 2)).epsilon(1e-16));
  CHECK(zonal::asin(-1.0) == -zonal::asin(1.0));
  CHECK(zonal::acos(1.0) == 0);
  CHECK(zonal::acos(1.0F) == 0);
  CHECK(zonal::angle_from(1.0, 0.0) == 0);
  CHECK(zonal::angle_from(-1.0, 0.0) == Catch::Approx(static_cast<double>(pi)).epsilon(1e-16));
  CHECK(zonal::angle_from(0.0, 1.0) == Catch::Approx(static_cast<double>(pi / 2)).epsilon(1e-16));
  // A cosine rounded beyond 1 is not a NaN.
  CHECK(zonal::angle_from(1.0000001F, 1e-4F) == Catch::Approx(1e-4F));
  CHECK(zonal::angle_from(1e-4F, 1.0000001F) == Catch::Approx(static_cast<float>(pi / 2) - 1e-4F));
}

TEST_CASE("exp is as accurate as promised") {
  check_exponentials<float, float>();
  check_exponentials<double, double>();
  check_exponentials<Packet<float, 8>, float>();
  check_exponentials<Packet<double, 4>, double>();
}

TEST_CASE("exp at its ends") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  CHECK(zonal::exp(0.0F) == 1);
  CHECK(zonal::exp(-0.0F) == 1);
  CHECK(zonal::exp(-200.0F) == 0);
  CHECK(zonal::exp(-infinity) == 0);
  CHECK(zonal::exp(200.0F) == infinity);
  CHECK(zonal::exp(infinity) == infinity);
  CHECK(std::isnan(zonal::exp(std::numeric_limits<float>::quiet_NaN())));
  CHECK(zonal::exp(-1000.0) == 0);
  CHECK(zonal::exp(1.0L) == Catch::Approx(2.718281828459045235).epsilon(1e-16));
}

TEST_CASE("min, max, abs, select and clamp of the built-in scalars") {
  CHECK(zonal::minimum(2.0F, 3.0F) == 2);
  CHECK(zonal::minimum(3.0F, 2.0F) == 2);
  CHECK(zonal::maximum(2.0F, 3.0F) == 3);
  CHECK(zonal::maximum(3.0F, 2.0F) == 3);
  CHECK(zonal::abs(-2.0) == 2);
  CHECK(zonal::abs(2.0) == 2);
  CHECK(zonal::select(true, 1.0, 2.0) == 1);
  CHECK(zonal::select(false, 1.0, 2.0) == 2);
  CHECK(zonal::clamp(5.0, 1.0, 3.0) == 3);
  CHECK(zonal::clamp(0.0, 1.0, 3.0) == 1);
  CHECK(zonal::clamp(2.0, 1.0, 3.0) == 2);
}

TEST_CASE("constexpr_sqrt is the square root to the last bit or one beside it") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-30, 29);
  for (int i = 0; i < 10000; ++i) {
    const long double x = std::pow(10.0L, static_cast<long double>(exponent(random)));
    CAPTURE(x);
    REQUIRE(std::abs(zonal::constexpr_sqrt(x) - std::sqrt(x)) <= ulp<long double>(std::sqrt(x)));
  }
  CHECK(zonal::constexpr_sqrt(0) == 0);
  CHECK(zonal::constexpr_sqrt(4) == 2);
}

TEST_CASE("exp: up to its range, where the processor takes the least numbers for zero too") {
#if defined(__SSE__)
  const unsigned kept = _mm_getcsr();
  _mm_setcsr(kept | 0x8040);  // flush to zero, and denormal numbers are zero
#endif
  float results[40];
  volatile float x = 86;
  for (int i = 0; i < 40; ++i) results[i] = zonal::exp(x + 0.0675F * static_cast<float>(i));  // to 88.6325
  const double large = zonal::exp(709.5 + 0 * static_cast<double>(x));
#if defined(__SSE__)
  _mm_setcsr(kept);
#endif
  for (int i = 0; i < 40; ++i) {
    const long double exact = std::exp(static_cast<long double>(86 + 0.0675F * static_cast<float>(i)));
    CAPTURE(i, results[i]);
    CHECK(std::abs(static_cast<long double>(results[i]) - exact) <= 6 * ulp<float>(exact));
  }
  CHECK(std::abs(static_cast<long double>(large) - std::exp(709.5L)) <= 6 * ulp<double>(std::exp(709.5L)));
}

TEST_CASE("with the library's names in scope, functions of integers are the standard library's") {
  using namespace zonal;
  CHECK(exp(2) == std::exp(2.0));
  CHECK(acos(0) == std::acos(0.0));
  CHECK(asin(1) == std::asin(1.0));
  CHECK(sqrt(2) == std::sqrt(2.0));
}
