// Bands known at run time, in loops, beside the kernels that are unrolled for as many.
#include <array>
#include <string>
#include <vector>

#include <zonal/many_bands/gradient.hpp>
#include <zonal/many_bands/lobes.hpp>
#include <zonal/many_bands/rotate.hpp>
#include <zonal/zonal.hpp>

#include "bench.hpp"
#include "many_bands_rows.hpp"

namespace zonal_bench {
namespace {

template <class T>
using Direction = std::array<T, 3>;

// Sixteen directions, one after the other.
template <class T>
class Directions {
 public:
  Directions() {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const T z = T(2) * (T(i) + T(0.5)) / T(16) - T(1), sine = std::sqrt(T(1) - z * z), phi = T(2.4) * T(i);
      all_[i] = {sine * std::cos(phi), sine * std::sin(phi), z};
    }
  }
  const Direction<T>& next() { return all_[++i_ % all_.size()]; }

 private:
  std::array<Direction<T>, 16> all_;
  std::size_t i_ = 0;
};

// Times run(result): what it writes into must then stand in memory.
template <class Result, class Run>
void time_runs(benchmark::State& state, Result& result, const Run& run) {
  for (auto _ : state) {
    run();
    benchmark::DoNotOptimize(&result);
    benchmark::ClobberMemory();
  }
  state.counters[time_counter] =
      benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = 1;
}

template <class T>
void run_evaluate(benchmark::State& state, int n) {
  const zonal::ManyBands<T> bands(n);
  zonal::BasisSpace<T> space(n);
  zonal::ManySh<T> sh(n);
  Directions<T> directions;
  time_runs(state, sh, [&] { zonal::evaluate(bands, directions.next(), space, sh.data()); });
}
template <int N, class T>
void run_unrolled_evaluate(benchmark::State& state) {
  zonal::Sh<N, T> sh;
  Directions<T> directions;
  time_runs(state, sh, [&] { sh = zonal::evaluate<N>(directions.next()); });
}

template <class T>
void run_gradient(benchmark::State& state, int n) {
  const zonal::ManyBands<T> bands(n);
  const zonal::ManyGradient<T> ladder(bands);
  zonal::BasisSpace<T> space(n);
  zonal::ManySh<T> sh(n), x(n), y(n), z(n);
  Directions<T> directions;
  time_runs(state, sh, [&] {
    zonal::evaluate_with_gradient(bands, ladder, directions.next(), space, sh.data(), x.data(), y.data(), z.data());
  });
}
template <int N, class T>
void run_unrolled_gradient(benchmark::State& state) {
  zonal::ShGradient<N, T> sh;
  Directions<T> directions;
  time_runs(state, sh, [&] { sh = zonal::evaluate_with_gradient<N>(directions.next()); });
}

template <class T>
void run_cap(benchmark::State& state, int n) {
  const zonal::ManyBands<T> bands(n);
  zonal::ManyZh<T> zh(n);
  Directions<T> directions;
  time_runs(state, zh, [&] {
    const T z = directions.next()[2];
    zonal::project(bands, zonal::SphericalCap<T>{z, std::sqrt(T(1) - z * z)}, zh.data());
  });
}
template <int N, class T>
void run_unrolled_cap(benchmark::State& state) {
  zonal::Zh<N, T> zh;
  Directions<T> directions;
  time_runs(state, zh, [&] {
    const T z = directions.next()[2];
    zh = zonal::project<N>(zonal::SphericalCap<T>{z, std::sqrt(T(1) - z * z)});
  });
}

template <class T>
void run_rotate(benchmark::State& state, int n) {
  const zonal::ManyRotation<T> rotation(n, zonal::Rotation<2, T>::from_zyz(T(0.3), T(1.1), T(-2)));
  zonal::SwapOfDegree<T> swap(n);
  zonal::ManySh<T> f(n), turned(n);
  std::vector<T> row(static_cast<std::size_t>(2 * n));
  for (int i = 0; i < f.size(); ++i) f[i] = T(1) / T(i + 1);
  time_runs(state, turned, [&] { zonal::rotate(f.data(), 1, rotation, swap, row.data(), turned.data()); });
}
template <int N, class T>
void run_unrolled_rotate(benchmark::State& state) {
  const auto rotation = zonal::Rotation<N, T>::from_zyz(T(0.3), T(1.1), T(-2));
  zonal::Sh<N, T> f, turned;
  for (int i = 0; i < N * N; ++i) f[i] = T(1) / T(i + 1);
  time_runs(state, turned, [&] { turned = zonal::rotate(f, rotation); });
}

template <class T>
void register_scalar(const char* scalar, const Effort& effort) {
  using Loop = void (*)(benchmark::State&, int);
  const std::array<Loop, many_bands_kernels.size()> loops{run_evaluate<T>, run_gradient<T>, run_cap<T>, run_rotate<T>};
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const int n : looped_bands) {
      if (n > zonal::greatest_bands<T>) continue;
      const auto run = [loop = loops[i], n](benchmark::State& state) { loop(state, n); };
      register_benchmark(std::string(many_bands_kernels[i]) + "-looped", n, scalar, run, effort);
    }
  }
  for_bands(UnrolledBands{}, [&](auto n) {
    const std::array<Body, many_bands_kernels.size()> unrolled{run_unrolled_evaluate<n, T>, run_unrolled_gradient<n, T>,
                                                               run_unrolled_cap<n, T>, run_unrolled_rotate<n, T>};
    for (std::size_t i = 0; i < unrolled.size(); ++i) {
      register_benchmark(std::string(many_bands_kernels[i]) + "-unrolled", n, scalar, unrolled[i], effort);
    }
  });
}

}  // namespace

void register_many_bands(const Effort& effort) {
  register_scalar<float>("float", effort);
  register_scalar<double>("double", effort);
}

}  // namespace zonal_bench
