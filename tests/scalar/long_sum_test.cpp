// Sums of many terms: the stated bound, for any number of them, where a plain sum fails.
#include <zonal/scalar/long_sum.hpp>

#include <cmath>
#include <random>
#include <vector>

#include "../catch.hpp"

namespace {

/// One number, added to block by block as kernels do it.
struct Sum {
  float sum = 0;
  template <class Visit>
  void for_each_sum(const Visit& visit) {
    visit(sum);
  }
};
float long_sum(const std::vector<float>& terms) {
  Sum sum;
  zonal::LongSums<float> totals;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (i > 0 && i % zonal::terms_in_block == 0) totals.take(sum);
    sum.sum += terms[i];
  }
  totals.finish(sum);
  return sum.sum;
}

struct Exact {
  double sum = 0, magnitude = 0;
  explicit Exact(const std::vector<float>& terms) {
    for (const float x : terms) sum += double(x), magnitude += std::abs(double(x));
  }
};
constexpr double unit = 0x1p-24;

}  // namespace

TEST_CASE("long sum: its error is bounded by what one block's is, for any number of terms") {
  std::mt19937 random(161);
  for (const std::size_t count : {1U, 2U, 63U, 64U, 65U, 128U, 4097U, 3000000U}) {
    for (int kind = 0; kind < 5; ++kind) {
      std::vector<float> terms(count);
      for (std::size_t i = 0; i < count; ++i) {
        const float uniform = std::uniform_real_distribution<float>(0, 1)(random);
        const float by_kind[] = {uniform, 1 / 3.0F, i == 0 ? 1.0F : 0x1p-25F, uniform - 0.5F,
                                 std::exp(27 * uniform - 13.5F)};  // powers that span 1e12
        terms[i] = by_kind[kind];
      }
      const Exact exact(terms);
      CAPTURE(count, kind, exact.sum, exact.magnitude);
      CHECK(std::abs(double(long_sum(terms)) - exact.sum) <= 65 * unit * exact.magnitude);
    }
  }
}

TEST_CASE("long sum: a plain sum of as many terms fails that bound, and one block is a plain sum") {
  std::vector<float> terms(3000000, 1 / 3.0F);
  const auto plain = [&] {
    float sum = 0;
    for (const float x : terms) sum += x;
    return double(sum);
  };
  const Exact exact(terms);
  CHECK(std::abs(plain() - exact.sum) > 1000 * 65 * unit * exact.magnitude);
  terms.resize(zonal::terms_in_block);
  CHECK(double(long_sum(terms)) == plain());
}
