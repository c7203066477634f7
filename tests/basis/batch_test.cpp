// Many directions at once, against each alone in double; what stands around the results, and at whatever place they do.
#include <zonal/basis/batch.hpp>
#include <zonal/transform/reconstruct_batch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "directions.hpp"

namespace {

using zonal::CoefficientPlanes;
using zonal::CoefficientRows;
using zonal::DirectionSpan;
using zonal::Stores;

template <class T>
inline constexpr std::size_t kLanes = zonal::native_lanes_v<T>;

/// `count` directions, exactly so many in memory, in the three forms that a batch takes.
template <class T>
struct Inputs {
  struct Padded {
    T w, x, y, z;
  };
  std::vector<Vector3<T>> vectors;
  std::vector<T> planes[3];
  std::vector<Padded> padded;

  explicit Inputs(std::size_t count) {
    if (count == 0) return;
    const auto all = directions_and_poles<T>(static_cast<int>(count), 20261126);
    vectors.assign(all.end() - static_cast<std::ptrdiff_t>(count), all.end());  // the six axes at the end
    for (const Vector3<T>& v : vectors) {
      for (std::size_t i = 0; i < 3; ++i) planes[i].push_back(v[i]);
      padded.push_back({T(1e30), v[0], v[1], v[2]});
    }
  }
  /// 0: triples, 1: planes, 2: vectors of one's own.
  DirectionSpan<T> span(int form) const {
    const std::size_t count = vectors.size();
    if (count == 0) return {};
    if (form == 0) return DirectionSpan<T>::triples(vectors[0].data(), count);
    if (form == 1) return DirectionSpan<T>::planes(planes[0].data(), planes[1].data(), planes[2].data(), count);
    return zonal::direction_span(padded.data(), count);
  }
};

/// Room for results, `offset` numbers beyond an aligned place, with a guard before and behind.
template <class T>
class Guarded {
 public:
  Guarded(std::size_t size, std::size_t offset) : size_(size), begin_(guard), numbers_(size + 3 * guard, untouched) {
    while (reinterpret_cast<std::uintptr_t>(data()) % 64 != 0) ++begin_;
    begin_ += offset;
  }
  T* data() { return numbers_.data() + begin_; }
  T operator[](std::size_t i) const { return numbers_[begin_ + i]; }
  /// How many numbers outside the results, and inside where is_result(i) does not hold, are not what they were.
  template <class IsResult>
  int overwritten(IsResult&& is_result) const {
    int count = 0;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const bool is_inside = i >= begin_ && i < begin_ + size_;
      if (!(is_inside && is_result(i - begin_)) && std::memcmp(&numbers_[i], &untouched, sizeof(T)) != 0) ++count;
    }
    return count;
  }

 private:
  static constexpr std::size_t guard = 64;
  static constexpr T untouched = T(12345);
  std::size_t size_, begin_;
  std::vector<T> numbers_;
};

template <class T>
Vector3<double> exact(const Vector3<T>& v) {
  return normalized(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

/// Every count of directions up to two packets and one more, in every form, in rows and in planes, aligned and not,
/// past the caches and not: each coefficient near evaluate() in double, and nothing else written.
template <int N, class T>
void check_evaluate() {
  constexpr std::size_t size = N * N;
  const double bound = accuracy_bound("evaluate", scalar_name<T>, sizeof(T) == sizeof(float) ? 5 : 21);
  for (std::size_t count = 0; count <= 2 * kLanes<T> + 1; ++count) {
    const Inputs<T> inputs(count);
    std::vector<zonal::Sh<N, double>> expected;
    for (const Vector3<T>& v : inputs.vectors) expected.push_back(zonal::evaluate<N>(exact(v)));

    const int form = static_cast<int>(count % 3);
    const std::size_t offset = count % 5;
    const std::size_t stride = count + (count % 2 == 0 ? 3 : 16 - count % 16);  // whole lines if count is odd
    for (const Stores stores : {Stores::by_size, Stores::cached, Stores::past_caches}) {
      Guarded<T> rows(count * size, offset), planes(stride * size, offset);
      zonal::evaluate<N>(inputs.span(form), CoefficientRows<T>{rows.data()}, stores);
      zonal::evaluate<N>(inputs.span(form), CoefficientPlanes<T>{planes.data(), stride}, stores);
      CAPTURE(N, sizeof(T), count, form, offset, stride, static_cast<int>(stores));
      CHECK(rows.overwritten([](std::size_t) { return true; }) == 0);
      CHECK(planes.overwritten([&](std::size_t i) { return i % stride < count; }) == 0);
      for (std::size_t k = 0; k < count; ++k) {
        for (int l = 0; l < N; ++l) {
          for (int m = -l; m <= l; ++m) {
            const auto i = static_cast<std::size_t>(zonal::sh_index(l, m));
            const double from_rows = static_cast<double>(rows[k * size + i]),
                         from_planes = static_cast<double>(planes[i * stride + k]);
            CAPTURE(k, l, m, inputs.vectors[k][0], inputs.vectors[k][1], inputs.vectors[k][2]);
            REQUIRE(std::abs(from_rows - expected[k](l, m)) <= bound * largest_of_degree(l));
            REQUIRE(std::abs(from_planes - expected[k](l, m)) <= bound * largest_of_degree(l));
          }
        }
      }
    }
  }
}

template <class T>
void check_gradient() {
  constexpr int bands = 3;
  for (std::size_t count = 0; count <= kLanes<T> + 1; ++count) {
    const Inputs<T> inputs(count);
    constexpr std::size_t size = 4 * bands * bands;
    Guarded<T> rows(count * size, 1), planes(count * size, 1);
    zonal::evaluate_with_gradient<bands>(inputs.span(0), CoefficientRows<T>{rows.data()});
    zonal::evaluate_with_gradient<bands>(inputs.span(1), CoefficientPlanes<T>{planes.data(), count});
    CHECK(rows.overwritten([](std::size_t) { return true; }) == 0);
    CHECK(planes.overwritten([](std::size_t) { return true; }) == 0);
    for (std::size_t k = 0; k < count; ++k) {
      const auto v = exact(inputs.vectors[k]);
      const auto expected = zonal::evaluate_with_gradient<bands>(v);
      const auto* const numbers = expected.value.values;
      for (std::size_t i = 0; i < size; ++i) {
        CAPTURE(sizeof(T), count, k, i, v[0], v[1], v[2]);
        const double bound = sizeof(T) == sizeof(float) ? 1e-6 : 2e-15;
        REQUIRE(std::abs(static_cast<double>(rows[k * size + i]) - numbers[i]) <= bound);
        REQUIRE(std::abs(static_cast<double>(planes[i * count + k]) - numbers[i]) <= bound);
      }
    }
  }
}

struct Colour {
  float c[3];
  float operator[](int i) const { return c[i]; }
  friend Colour operator*(const Colour& a, float b) { return {{a.c[0] * b, a.c[1] * b, a.c[2] * b}}; }
  friend Colour operator+(const Colour& a, const Colour& b) {
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}};
  }
};

template <int N>
std::vector<float> all_rows(const DirectionSpan<float>& directions, Stores stores, std::size_t offset = 0) {
  std::vector<float> rows(directions.count * N * N + offset);
  zonal::evaluate<N>(directions, CoefficientRows<float>{rows.data() + offset}, stores);
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(offset));
  return rows;
}
bool same_bits(const float* a, const float* b, std::size_t size) {
  return std::memcmp(a, b, size * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("A batch is evaluate of each direction, and writes nothing else") {
  check_evaluate<1, float>();
  check_evaluate<2, float>();
  check_evaluate<3, float>();
  check_evaluate<5, float>();
  check_evaluate<2, double>();
  check_evaluate<3, double>();
}

TEST_CASE("A batch with gradients is evaluate_with_gradient of each direction") {
  check_gradient<float>();
  check_gradient<double>();
}

TEST_CASE("A batch of values is reconstruct in each direction, of numbers and of colours") {
  constexpr int bands = 4;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  zonal::Sh<bands, Colour> colours;
  zonal::Sh<bands, float> numbers;
  for (int i = 0; i < numbers.size(); ++i) {
    numbers[i] = uniform(random);
    colours[i] = {{uniform(random), numbers[i], uniform(random)}};
  }
  const auto in_double = zonal::Sh<bands, double>(numbers);
  for (std::size_t count = 0; count <= kLanes<float> + 1; ++count) {
    const Inputs<float> inputs(count);
    Guarded<float> values(count, 1), rgb(3 * count, 1);
    zonal::reconstruct(numbers, inputs.span(0), values.data());
    zonal::reconstruct(colours, inputs.span(0), static_cast<Colour*>(static_cast<void*>(rgb.data())));
    CHECK(values.overwritten([](std::size_t) { return true; }) == 0);
    CHECK(rgb.overwritten([](std::size_t) { return true; }) == 0);
    for (std::size_t k = 0; k < count; ++k) {
      const auto v = inputs.vectors[k];
      CAPTURE(count, k, v[0], v[1], v[2]);
      // 16 products of up to 1, each with what evaluate may be off.
      REQUIRE(std::abs(static_cast<double>(values[k]) - zonal::reconstruct(in_double, exact(v))) <= 2e-6);
      const Colour expected = zonal::reconstruct(colours, v);
      for (std::size_t c = 0; c < 3; ++c) REQUIRE(std::abs(rgb[3 * k + c] - expected[static_cast<int>(c)]) <= 2e-6F);
    }
  }
}

TEST_CASE("A direction's results do not depend on its place in a batch, or on the batch's size, to the bit") {
  constexpr int bands = 5;
  constexpr std::size_t size = bands * bands, most = 2 * kLanes<float> + 1;
  const Inputs<float> inputs(most);
  const auto all = all_rows<bands>(inputs.span(0), Stores::cached);
  for (std::size_t begin = 0; begin < most; ++begin) {
    for (std::size_t count = 1; begin + count <= most; ++count) {
      const auto part = DirectionSpan<float>::triples(inputs.vectors[begin].data(), count);
      CAPTURE(begin, count);
      REQUIRE(same_bits(all_rows<bands>(part, Stores::cached).data(), &all[begin * size], count * size));
    }
  }
}

TEST_CASE("Past the caches, and in runs of planes, results are the same to the bit") {
  constexpr int bands = 5;
  constexpr std::size_t size = bands * bands, count = 1003;
  const Inputs<float> inputs(count);
  const auto expected = all_rows<bands>(inputs.span(0), Stores::cached);
  for (std::size_t offset = 0; offset < 17; ++offset) {
    CAPTURE(offset);
    REQUIRE(all_rows<bands>(inputs.span(2), Stores::past_caches, offset) == expected);
    for (const std::size_t stride :
         {std::size_t{1008}, std::size_t{1024}}) {  // whose planes a first-level cache holds, or not
      for (const Stores stores : {Stores::cached, Stores::past_caches}) {
        CAPTURE(stride, static_cast<int>(stores));
        std::vector<float> planes(stride * size + offset);
        zonal::evaluate<bands>(inputs.span(1), CoefficientPlanes<float>{planes.data() + offset, stride}, stores);
        std::size_t different = 0;
        for (std::size_t k = 0; k < count; ++k) {
          for (std::size_t i = 0; i < size; ++i) {
            if (!same_bits(&planes[offset + i * stride + k], &expected[k * size + i], 1)) ++different;
          }
        }
        REQUIRE(different == 0);
      }
    }
  }
}

TEST_CASE("Planes are stored in runs where they would crowd each other out of a first-level cache") {
  using zonal::detail::fits_planes;
  CHECK(fits_planes(25, 4032));        // 63 lines apart: all places
  CHECK(fits_planes(25, 4));           // across lines
  CHECK(fits_planes(25, 512));         // 8 places
  CHECK_FALSE(fits_planes(25, 1024));  // 4 places, of 8 lines each
  CHECK_FALSE(fits_planes(25, 4096 * 5));
  CHECK_FALSE(fits_planes(4 * 100, 64));
}

TEST_CASE("Results that no cache holds go past the caches, and are the same") {
  CHECK(zonal::detail::is_past_caches(Stores::by_size, (std::size_t{32} << 20) + 1));
  CHECK_FALSE(zonal::detail::is_past_caches(Stores::by_size, std::size_t{32} << 20));
  CHECK_FALSE(zonal::detail::is_past_caches(Stores::cached, std::size_t{1} << 40));
  CHECK(zonal::detail::is_past_caches(Stores::past_caches, 1));

  constexpr int bands = 4;
  constexpr std::size_t size = bands * bands, few = 1001, count = 540 * few;
  const Inputs<float> inputs(few);
  const auto expected = all_rows<bands>(inputs.span(0), Stores::cached);
  std::vector<Vector3<float>> repeated;
  for (std::size_t k = 0; k < count; ++k) repeated.push_back(inputs.vectors[k % few]);
  const auto rows = all_rows<bands>(zonal::direction_span(repeated.data(), count), Stores::by_size);
  REQUIRE(rows.size() * sizeof(float) > std::size_t{32} << 20);
  for (std::size_t i = 0; i < 540; ++i) {
    CAPTURE(i);
    REQUIRE(same_bits(&rows[i * few * size], expected.data(), few * size));
  }
}
