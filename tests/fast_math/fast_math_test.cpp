// What docs/floating_point.md says of -ffast-math, of contraction and of denormals taken for zero.
#include <zonal/accuracy.hpp>
#include <zonal/kernels/sampler.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "chosen_kernels.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

std::vector<KernelResults> plain_results(const std::vector<std::vector<float>>& inputs, int runs) {
  return kernels_of_each_kind::results_of(kernels_of_each_kind::Kernels{}, inputs, runs);
}

namespace {

constexpr int draws = 2000;

/// Such as a renderer has, half of them hard.
std::vector<std::vector<float>> usual_inputs() {
  using namespace kernels_of_each_kind;
  std::vector<std::vector<float>> all;
  for_each_kernel(Kernels{}, [&](auto entry) {
    DescribingIo<float> io([](const Parameter&) { return 0.5F; });
    decltype(entry)::template run<kBands>(io);
    InputSampler sampler(27, kBands, Draw::hard);
    std::vector<float>& numbers = all.emplace_back();
    for (int i = 0; i < draws; ++i) {
      for (const double number : sampler.draw(io.parameters())) numbers.push_back(static_cast<float>(number));
    }
  });
  return all;
}

/// The greatest difference in ulps of a run's largest number, or of the root mean square of all runs' where sums may
/// cancel; infinite where one is no number.
double difference(const KernelResults& found, const KernelResults& expected, std::string_view unit) {
  const std::size_t size = expected.results.size() / draws;
  double squares = 0;
  for (const float x : expected.results) squares += static_cast<double>(x) * static_cast<double>(x);
  const double typical =
      unit == zonal::accuracy::kUlpOfLargest ? 0 : std::sqrt(squares / static_cast<double>(expected.results.size()));
  double worst = 0;
  for (std::size_t first = 0; first < expected.results.size(); first += size) {
    double largest = typical, error = 0;
    for (std::size_t i = first; i < first + size; ++i) {
      largest = std::max(largest, static_cast<double>(std::abs(expected.results[i])));
      const double e = std::abs(static_cast<double>(found.results[i]) - static_cast<double>(expected.results[i]));
      error = e <= error ? error : std::isnan(e) ? std::numeric_limits<double>::infinity() : e;
    }
    if (error > 0)
      worst = std::max(worst, error / largest / static_cast<double>(std::numeric_limits<float>::epsilon()));
  }
  return worst;
}

/// The greatest difference of all kernels.
template <class Results>
double check_near(const Results& results) {
  double worst = 0;
  const auto inputs = usual_inputs();
  const auto plain = plain_results(inputs, draws), others = results(inputs, draws);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const Accuracy promise = accuracy_of(plain[i].name, zonal::accuracy::kAnyScalar, run_bands);
    const double found = difference(others[i], plain[i], promise.unit);
    CAPTURE(plain[i].name, found);
    CHECK(found <= 2 * promise.bound);
    worst = std::max(worst, found);
    if (std::getenv("ZONAL_PRINT_WORST") != nullptr) std::printf("%s %.3g\n", plain[i].name.c_str(), found);
  }
  return worst;
}

}  // namespace

TEST_CASE("fast math: usual inputs give finite numbers, no farther off than twice what the table has") {
  check_near(fast_results);
}

TEST_CASE("contraction: results are no farther off than twice what the table has") {
  [[maybe_unused]] const double worst = check_near(contracted_results);
#if defined(__FMA__)
  CHECK(worst > 0);  // something was fused
#endif
}

TEST_CASE("flush to zero: what is no denormal number is the same to the bit") {
#if defined(__SSE2__)
  const auto inputs = usual_inputs();
  const auto kept = plain_results(inputs, draws);
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);  // flush to zero, and denormals are zeros
  const auto flushed = plain_results(inputs, draws);
  _mm_setcsr(before);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t k = 0; k < kept[i].results.size(); ++k) {
      const float a = flushed[i].results[k], b = kept[i].results[k];
      const bool is_same = a == b || (std::abs(b) < std::numeric_limits<float>::min() && a == 0);
      if (is_same) continue;
      CAPTURE(kept[i].name, k, a, b);
      FAIL_CHECK("not the same");
    }
  }
#else
  std::printf("skipped: no SSE2\n");
#endif
}
