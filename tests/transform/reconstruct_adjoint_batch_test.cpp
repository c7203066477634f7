// Many colours at once, against each alone; in 32 and 16 bits; whatever the number, and nothing written beside.
#include <glm/vec3.hpp>
#include <zonal/transform/reconstruct_adjoint_batch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <type_traits>
#include <vector>

#include "../catch.hpp"

namespace {

using zonal::ColourRule;
using zonal::Half;
using zonal::to_float;

template <class Number>
Number rounded(float x) {
  if constexpr (std::is_same_v<Number, Half>) {
    return zonal::to_half(x);
  } else {
    return x;
  }
}
std::uint16_t bits(Half x) { return x.bits; }
float bits(float x) { return x; }

/// Inputs and results of `count` directions, the results with a guard behind.
template <int N, class In, class Out>
struct Data {
  static constexpr std::size_t size = 3 * N * N;
  static constexpr float guard = 12345;
  std::size_t count;
  std::vector<In> sh;
  std::vector<float> directions, by_value, value, by_direction;
  std::vector<Out> by_sh;

  explicit Data(std::size_t number)
      : count(number),
        value(3 * number + 3, guard),
        by_direction(value),
        by_sh(size * (number + 1), rounded<Out>(guard)) {
    std::mt19937 random(31);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (std::size_t i = 0; i < size * count; ++i) sh.push_back(rounded<In>(uniform(random)));
    for (std::size_t i = 0; i < 3 * count; ++i) {
      directions.push_back(10 * uniform(random));
      by_value.push_back(uniform(random));
    }
  }
  zonal::ColourBatch<In> batch(std::size_t first = 0) const {
    return {sh.data() + size * first, directions.data() + 3 * first, by_value.data() + 3 * first, count - first};
  }
  zonal::AdjointBatch<Out> results(std::size_t first = 0) {
    return {value.data() + 3 * first, by_sh.data() + size * first, by_direction.data() + 3 * first};
  }
};

template <int N, class In, class Out>
void check(std::size_t count) {
  CAPTURE(N, sizeof(In), sizeof(Out), count);
  Data<N, In, Out> data(count);
  zonal::reconstruct_with_adjoint<N, ColourRule::splat>(data.batch(), data.results());
  const auto triple = [](const std::vector<float>& numbers, std::size_t i) {
    return glm::vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  };
  for (std::size_t k = 0; k < count; ++k) {
    zonal::Sh<N, glm::vec3> sh;
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) sh[i][c] = to_float(data.sh[k * data.size + std::size_t(3 * i + c)]);
    }
    const glm::vec3 direction = triple(data.directions, k);
    const auto one = zonal::reconstruct_with_adjoint<ColourRule::splat>(sh, direction, triple(data.by_value, k));
    const float length = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
    const float half_ulp = std::is_same_v<Out, Half> ? 5e-4F : 0;
    for (int c = 0; c < 3; ++c) {
      CAPTURE(k, c);
      CHECK(std::abs(triple(data.value, k)[c] - one.value[c]) <= 1e-5F);
      CHECK(std::abs(triple(data.by_direction, k)[c] - one.by_direction[c]) * length <= 2e-5F);
      for (int i = 0; i < N * N; ++i) {
        const float found = to_float(data.by_sh[k * data.size + std::size_t(3 * i + c)]);
        CHECK(std::abs(found - one.by_sh[i][c]) <= 2e-6F + half_ulp * std::abs(one.by_sh[i][c]));
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    CHECK((data.value[3 * count + i] == data.guard && data.by_direction[3 * count + i] == data.guard));
  for (std::size_t i = 0; i < data.size; ++i)
    CHECK(bits(data.by_sh[count * data.size + i]) == bits(rounded<Out>(data.guard)));

  // Values alone; and from the second direction on, in other lanes: the same to the bit.
  std::vector<float> alone(3 * count + 3, data.guard);
  zonal::reconstruct_along<N, ColourRule::splat>(data.batch(), alone.data());
  for (std::size_t i = 0; i < alone.size(); ++i) CHECK(std::abs(alone[i] - data.value[i]) <= 1e-5F);
  if (count == 0) return;
  Data<N, In, Out> moved(count);
  zonal::reconstruct_with_adjoint<N, ColourRule::splat>(moved.batch(1), moved.results(1));
  for (std::size_t i = 3; i < 3 * count; ++i) {
    CHECK(moved.value[i] == data.value[i]);
    CHECK(moved.by_direction[i] == data.by_direction[i]);
  }
  for (std::size_t i = data.size; i < count * data.size; ++i) CHECK(bits(moved.by_sh[i]) == bits(data.by_sh[i]));
}

}  // namespace

TEST_CASE("adjoint batch: each is what it is alone") {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 16U, 17U, 33U, 67U}) {
    check<4, Half, Half>(count);
    check<4, float, float>(count);
    check<3, Half, float>(count);
    check<3, float, Half>(count);
  }
  check<1, Half, Half>(19);
  check<2, float, float>(19);
  check<5, Half, Half>(19);
}

TEST_CASE("adjoint batch: what is not asked for is not written") {
  Data<4, float, float> data(20);
  zonal::reconstruct_with_adjoint<4>(data.batch(), zonal::AdjointBatch<float>{nullptr, data.by_sh.data(), nullptr});
  CHECK(data.by_sh[0] == Approx(data.by_value[0] * 0.2820948F));
  zonal::reconstruct_with_adjoint<4>(data.batch(), zonal::AdjointBatch<float>{data.value.data(), nullptr, nullptr});
  CHECK(data.value[0] != data.guard);
  CHECK(data.by_direction[0] == data.guard);
}

TEST_CASE("adjoint batch: halves in registers are those one by one") {
  using zonal::detail::HalfPairs;
  constexpr int lanes = zonal::kNativeLanes;
  for (int first = 0; first < 65536; first += 2 * lanes) {
    std::array<std::uint16_t, std::size_t{2 * lanes}> halves, back;
    for (int i = 0; i < 2 * lanes; ++i) halves[std::size_t(i)] = std::uint16_t(first + i);
    float words[lanes];
    std::memcpy(words, halves.data(), sizeof words);
    const auto parts = zonal::detail::split(HalfPairs::load(words));
    zonal::detail::join(parts.first, parts.second).store(words);
    std::memcpy(back.data(), words, sizeof words);
    float numbers[2][lanes];
    parts.first.store(numbers[0]), parts.second.store(numbers[1]);
    for (int i = 0; i < 2 * lanes; ++i) {
      const float expected = to_float(Half{halves[std::size_t(i)]});
      const float found = numbers[i % 2][i / 2];
      CAPTURE(halves[std::size_t(i)], found, expected);
      if (std::isnan(expected)) {
        REQUIRE(std::isnan(found));
        REQUIRE(std::isnan(to_float(Half{back[std::size_t(i)]})));
      } else {
        REQUIRE(found == expected);
        REQUIRE(std::signbit(found) == std::signbit(expected));
        REQUIRE(back[std::size_t(i)] == halves[std::size_t(i)]);
      }
    }
  }
  // Between two halves, and exactly there; beyond the largest, and below the least.
  std::mt19937 random(32);
  std::uniform_real_distribution<float> exponent(-28, 18), mantissa(1, 2);
  for (int k = 0; k < 20000; ++k) {
    float a[lanes], b[lanes];
    for (int i = 0; i < lanes; ++i) {
      const float middle = 1 + (float(random() % 1024) + 0.5F) / 1024;
      a[i] = std::ldexp(k % 2 == 0 ? mantissa(random) : middle, int(exponent(random)));
      b[i] = -std::nextafter(a[i], 1e9F);
    }
    float words[lanes];
    zonal::detail::join(HalfPairs::load(a), HalfPairs::load(b)).store(words);
    std::array<std::uint16_t, std::size_t{2 * lanes}> found;
    std::memcpy(found.data(), words, sizeof words);
    for (std::size_t i = 0; i < std::size_t{lanes}; ++i) {
      CAPTURE(a[i], b[i]);
      REQUIRE(found[2 * i] == zonal::to_half(a[i]).bits);
      REQUIRE(found[2 * i + 1] == zonal::to_half(b[i]).bits);
    }
  }
}
