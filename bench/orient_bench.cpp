// A zonal lobe turned to an axis.

#include <zonal/transform/orient.hpp>

#include <algorithm>

#include "bench.hpp"

namespace zonal_bench {
namespace {

template <int N>
struct Orient {
  static constexpr int inputs = 3 + N;

  static std::array<double, inputs> draw(Random& random) {
    std::array<double, inputs> numbers;
    const auto axis = random_direction(random);
    std::copy(axis.begin(), axis.end(), numbers.begin());
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::generate(numbers.begin() + 3, numbers.end(), [&] { return uniform(random); });
    return numbers;
  }

  template <class T>
  static auto run(const std::array<T, inputs>& numbers) {
    zonal::Zh<N, T> zh;
    std::copy(numbers.begin() + 3, numbers.end(), zh.begin());
    return zonal::orient(zh, numbers);
  }
};

}  // namespace

void register_orient(const Effort& effort) { register_kernels<Orient, 10>("orient", effort); }

}  // namespace zonal_bench
