#include "limits.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <zonal/scalar/packet.hpp>
#include <zonal/scalar/unroll.hpp>

namespace zonal_bench {
namespace {

using Lanes = zonal::Packet<float, zonal::kNativeLanes>;
using zonal_report::Body;

// As many as registers hold, with two operands, and more than the longest wait of an addition or a multiplication.
constexpr int chains = 12;
constexpr int rounds = 1000;

// step(i, value) in `chains` chains that do not wait for each other, `rounds` times.
template <class Step>
Body in_chains(Step step) {
  return [step] {
    Lanes values[chains];
    zonal::unroll<0, chains>([&](auto i) ZONAL_INLINE { values[i] = Lanes(1 + 0.01 * i); });
    for (int round = 0; round < rounds; ++round) {
      zonal::unroll<0, chains>([&](auto i) ZONAL_INLINE { step(i, values[i]); });
    }
    Lanes sum(0);  // the array itself asked for would stand in memory all the time
    zonal::unroll<0, chains>([&](auto i) ZONAL_INLINE { sum = sum + values[i]; });
    benchmark::DoNotOptimize(sum);
  };
}

// Half of the smallest first-level caches: so many registers.
constexpr int registers = int(std::size_t{16 * 1024} / sizeof(Lanes));
using Block = std::array<Lanes, std::size_t{registers}>;

Body loads() {
  return [block = Block{}] {
    Lanes sums[8];
    for (Lanes& sum : sums) sum = Lanes(0);
    for (int i = 0; i < registers; i += 16) {
      for (int k = 0; k < 8; ++k) {
        const auto at = static_cast<std::size_t>(i + 2 * k);
        add_product(sums[k], block[at], block[at + 1]);
      }
    }
    for (Lanes& sum : sums) benchmark::DoNotOptimize(sum);
  };
}

Body stores() {
  return [block = Block{}]() mutable {
    const Lanes value(1.5);
    for (Lanes& target : block) target = value;
    benchmark::DoNotOptimize(block.data());
    benchmark::ClobberMemory();
  };
}

}  // namespace

Limits measure_limits(const zonal_report::Repetitions& repetitions) {
  const Lanes a(0.75), b(1.5);
  const std::vector<Body> bodies{
      in_chains([=](int, Lanes& value) ZONAL_INLINE {
        Lanes sum = b;
        add_product(sum, value, a);
        value = sum;
      }),
      in_chains([=](int i, Lanes& value) ZONAL_INLINE {
        Lanes sum = b;
        add_product(sum, value, a);
        value = i % 2 == 0 ? sum : value + b;
      }),
      in_chains([=](int, Lanes& value) ZONAL_INLINE { value = b / value; }),
      in_chains([=](int, Lanes& value) ZONAL_INLINE { value = sqrt(value + b); }),
      loads(),
      stores(),
  };
  const std::vector<double> seconds = median_seconds(bodies, repetitions);
  const auto of_chains = [&](std::size_t i) { return 1e9 * seconds[i] / (chains * rounds); };
  const auto of_block = [&](std::size_t i) { return 1e9 * seconds[i] / registers; };
  return {of_chains(0), of_chains(1), of_chains(2), of_chains(3), of_block(4), of_block(5)};
}

Bound find_bound(const Limits& limits, const Work& work) {
  const zonal::OperationCount& count = work.count;
  const std::array bounds{
      Bound{"multiply", limits.multiply * count.multiplications},
      Bound{"operations", limits.operation * (count.total() - count.fused)},
      Bound{"divide", limits.divide * count.divisions + limits.root * count.functions},
      Bound{"load", limits.load * work.loads},
      Bound{"store", limits.store * work.stores},
  };
  return *std::max_element(bounds.begin(), bounds.end(), [](const Bound& x, const Bound& y) { return x.ns < y.ns; });
}

}  // namespace zonal_bench
